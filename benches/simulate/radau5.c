/* The equations of angles.py for R's deSolve: y' of y = (θ, θ'). Sizes and data are those of scene.h, which with_radau5.py writes. */
#include <math.h>
#include "scene.h"

enum { ROWS = N + M };

static void solve(double a[ROWS][ROWS], double b[ROWS]) {
    for (int k = 0; k < ROWS; k++) {
        int most = k;
        for (int i = k + 1; i < ROWS; i++)
            if (fabs(a[i][k]) > fabs(a[most][k])) most = i;
        for (int j = k; j < ROWS && most != k; j++) {
            double x = a[k][j];
            a[k][j] = a[most][j], a[most][j] = x;
        }
        double x = b[k];
        b[k] = b[most], b[most] = x;
        for (int i = k + 1; i < ROWS; i++) {
            double part = a[i][k] / a[k][k];
            if (part == 0.0) continue;
            for (int j = k + 1; j < ROWS; j++) a[i][j] -= part * a[k][j];
            b[i] -= part * b[k];
        }
    }
    for (int k = ROWS - 1; k >= 0; k--) {
        for (int j = k + 1; j < ROWS; j++) b[k] -= a[k][j] * b[j];
        b[k] /= a[k][k];
    }
}

void rates(int *count, double *t, double *y, double *dy, double *out, int *ip) {
    double c[N], s[N], a[ROWS][ROWS] = {{0}}, b[ROWS] = {0}, *v = y + N;
    for (int k = 0; k < N; k++) {
        c[k] = cos(y[k]), s[k] = sin(y[k]);
        a[k][k] = inertia[k], b[k] = torque[k];
    }
    for (int body = 0; body < N; body++) {
        double jx[N], jy[N], ax = 0.0, ay = -gravity;
        for (int k = 0; k < N; k++) {
            double x = centres[body][k][0], z = centres[body][k][1];
            double px = c[k] * x - s[k] * z, py = s[k] * x + c[k] * z;
            jx[k] = -py, jy[k] = px;
            ax += px * v[k] * v[k], ay += py * v[k] * v[k];
        }
        for (int i = 0; i < N; i++) {
            if (jx[i] == 0.0 && jy[i] == 0.0) continue;
            b[i] += mass[body] * (jx[i] * ax + jy[i] * ay);
            for (int k = 0; k < N; k++) a[i][k] += mass[body] * (jx[i] * jx[k] + jy[i] * jy[k]);
        }
    }
    if (spring[2] != 0.0) {
        double x = spring[0], z = spring[1];
        for (int k = 0; k < N; k++) {
            x += c[k] * eye[k][0] - s[k] * eye[k][1];
            z += s[k] * eye[k][0] + c[k] * eye[k][1];
        }
        double length = sqrt(x * x + z * z), pull = -spring[2] * (length - spring[3]) / length;
        for (int k = 0; k < N; k++) {
            double px = c[k] * eye[k][0] - s[k] * eye[k][1], py = s[k] * eye[k][0] + c[k] * eye[k][1];
            b[k] += pull * (-py * x + px * z);
        }
    }
    for (int loop = 0; loop < M / 2; loop++) {
        int row = N + 2 * loop;
        for (int k = 0; k < N; k++) {
            double x = loops[loop][k][0], z = loops[loop][k][1];
            double px = c[k] * x - s[k] * z, py = s[k] * x + c[k] * z;
            a[row][k] = a[k][row] = -py, a[row + 1][k] = a[k][row + 1] = px;
            b[row] += px * v[k] * v[k], b[row + 1] += py * v[k] * v[k];
        }
    }
    solve(a, b);
    for (int k = 0; k < N; k++) dy[k] = v[k], dy[N + k] = b[k];
}
