//! Numbers, vectors and linear systems.

mod chebyshev;
mod dense;
mod double;
mod factors;
mod lanes;
mod lobatto;
mod magnitudes;
mod ode;
mod periodic;
mod quadrature;
mod ratio;
mod root;
mod sparse;
mod table_function;
