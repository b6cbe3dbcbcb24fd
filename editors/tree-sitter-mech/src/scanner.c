// Units: one word after a number, `kg*m^2`, that ends before what is not a unit: `6 mm*cos(a)`.

#include "tree_sitter/parser.h"

#include <string.h>

enum TokenType { UNIT, ERROR_SENTINEL };

// words: units
static const char *const UNITS[] = {"m", "mm", "um", "µm", "cm", "dm", "km", "inch", "ft", "kg", "g", "t", "lb", "slug", "s", "ms", "min", "h", "rad", "deg", "°", "gon", "rev", "rpm", "Hz", "N", "daN", "kN", "MN", "lbf", "kgf", "kp", "J", "kJ", "W", "kW", "MW", "hp", "PS", "Pa", "kPa", "MPa", "GPa", "bar", "psi", "%"};

// What may come after a blank or a point: `N m`.
// words: units after a blank
static const char *const LAST[] = {"mm", "cm", "min", "ms", "m", "kg", "s", "h", "rad", "inch", "ft"};

#define LENGTH(list) (sizeof(list) / sizeof(*(list)))

static bool is_digit(int32_t c) { return c >= '0' && c <= '9'; }

static bool is_name(int32_t c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_' || c == '\'' ||
         (c >= 0x80 && c != 0xB7 && c != 0x22C5 && c != 0xA0 && c != 0x2212 && c != 0x2013 && c != 0xB0 && c != 0xFEFF &&
          c != 0xB2 && c != 0xB3 && c != 0xB9 && !(c >= 0x2070 && c <= 0x207F));
}

static bool is_superscript(int32_t c) {
  return c == 0xB2 || c == 0xB3 || c == 0xB9 || (c >= 0x2070 && c <= 0x2079) || c == 0x207B;
}

static bool is_minus(int32_t c) { return c == '-' || c == 0x2212; }

// Reads a word into UTF-8; false where it is too long for a unit.
static bool read_word(TSLexer *lexer, char *word, size_t size) {
  size_t length = 0;
  int32_t c = lexer->lookahead;
  bool sign = c == '%' || c == 0xB0;
  if (!sign && (!is_name(c) || is_digit(c) || c == '_' || c == '\'')) return false;
  do {
    c = lexer->lookahead;
    if (length + 4 > size) return false;
    if (c < 0x80) {
      word[length++] = (char)c;
    } else if (c < 0x800) {
      word[length++] = (char)(0xC0 | (c >> 6));
      word[length++] = (char)(0x80 | (c & 0x3F));
    } else {
      return false;
    }
    lexer->advance(lexer, false);
  } while (!sign && is_name(lexer->lookahead));
  word[length] = 0;
  return true;
}

static bool is_in(const char *word, const char *const *list, size_t length) {
  for (size_t i = 0; i < length; i++) {
    if (strcmp(word, list[i]) == 0) return true;
  }
  return false;
}

// `^-2`, `²`; nothing is a power too. False where the power is no number: `mm^n`.
static bool read_power(TSLexer *lexer) {
  if (lexer->lookahead == '^') {
    lexer->advance(lexer, false);
    if (is_minus(lexer->lookahead)) lexer->advance(lexer, false);
    if (!is_digit(lexer->lookahead)) return false;
    while (is_digit(lexer->lookahead)) lexer->advance(lexer, false);
  }
  while (is_superscript(lexer->lookahead)) lexer->advance(lexer, false);
  return true;
}

static bool read_factor(TSLexer *lexer, const char *const *list, size_t length) {
  char word[16];
  return read_word(lexer, word, sizeof word) && is_in(word, list, length);
}

void *tree_sitter_mech_external_scanner_create(void) { return NULL; }
void tree_sitter_mech_external_scanner_destroy(void *payload) { (void)payload; }
unsigned tree_sitter_mech_external_scanner_serialize(void *payload, char *buffer) {
  (void)payload;
  (void)buffer;
  return 0;
}
void tree_sitter_mech_external_scanner_deserialize(void *payload, const char *buffer, unsigned length) {
  (void)payload;
  (void)buffer;
  (void)length;
}

bool tree_sitter_mech_external_scanner_scan(void *payload, TSLexer *lexer, const bool *valid) {
  (void)payload;
  // in error recovery all tokens are valid: a name must not become a unit
  if (!valid[UNIT] || valid[ERROR_SENTINEL]) return false;
  while (lexer->lookahead == ' ' || lexer->lookahead == '\t' || lexer->lookahead == 0xA0) lexer->advance(lexer, true);
  if (lexer->lookahead == '1') {
    lexer->advance(lexer, false);
    if (lexer->lookahead != '/') return false;
    lexer->advance(lexer, false);
  }
  if (!read_factor(lexer, UNITS, LENGTH(UNITS))) return false;
  lexer->result_symbol = UNIT;
  lexer->mark_end(lexer);
  if (!read_power(lexer)) return true;
  lexer->mark_end(lexer);
  for (;;) {
    int32_t joint = lexer->lookahead;
    bool product = joint == '*' || joint == '/' || joint == 0xB7 || joint == 0x22C5;
    if (!product && joint != ' ' && joint != '.') return true;
    lexer->advance(lexer, false);
    bool is_unit = product ? read_factor(lexer, UNITS, LENGTH(UNITS)) : read_factor(lexer, LAST, LENGTH(LAST));
    if (!is_unit || !read_power(lexer)) return true;
    // a factor that is called, or has a part, is not a unit
    if (lexer->lookahead == '(' || lexer->lookahead == '^') return true;
    if (lexer->lookahead != '.') lexer->mark_end(lexer);
  }
}
