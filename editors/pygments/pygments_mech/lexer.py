"""A lexer of `.mech`: a number with its unit is one token."""

import re

from pygments.lexer import RegexLexer, bygroups, include, words
from pygments.token import Comment, Keyword, Name, Number, Operator, Punctuation, String, Whitespace

from . import words as w

LETTER = r"[^\W\d_]"
MORE = r"(?:[^\W²³¹⁰-⁹]|['₀-₉])"
END = rf"(?!{MORE})"
START = rf"(?<!{MORE})"
POWER = r"(?:\^[-−]?[0-9]+|[²³¹⁰⁴-⁹⁻]+)?"
AFTER = rf"(?![(^]|\.{LETTER})"
FACTOR = rf"(?:{'|'.join(map(re.escape, w.UNITS))}){END}{POWER}"
# what may come after a blank or a point: `N m`
LAST = rf"(?:{'|'.join(w.LAST_UNITS)}){END}{POWER}"
UNIT = rf"(?:1/)?{FACTOR}(?:[*/·⋅]{FACTOR}{AFTER}|[ .]{LAST}{AFTER})*"
NUMBER = r"[0-9]+(?:\.[0-9]+)?(?:[eE][+−-]?[0-9]+)?"
NAME = rf"{LETTER}{MORE}*"
BEFORE_NAMES = "line circle profile wheel on event for to through centre of given let".split()
# a word that is a name where this follows is not the first of a statement
NOT_HEAD = r"(?!\s*(?:[(=,.;}]|$))"


def head(list_of_words, before):
    """The words at the beginning of a statement or a member."""
    return rf"({before})([ \t]*)({'|'.join(list_of_words)}){END}"


def after(*before):
    """What is before a name, with one blank."""
    return "(?:" + "|".join(rf"(?<=\b{word} )" for word in before) + ")"


class MechLexer(RegexLexer):
    """Problems of planar mechanisms, as `assur` solves them."""

    name = "Mech"
    aliases = ["mech"]
    filenames = ["*.mech"]
    mimetypes = ["text/x-mech"]
    version_added = "2.0"
    flags = re.MULTILINE

    tokens = {
        "root": [
            (r"//.*$", Comment.Single),
            (r'"[^"\n]*"?', String),
            # the name of a row of variants: `B-2`
            (rf"^([ \t]*)({LETTER}(?:{MORE}|[.-])*)(?=[ \t]*,[ \t]*[-−]?[0-9])", bygroups(Whitespace, Name)),
            (rf"{START}(pose)([ \t]+)({MORE}+)", bygroups(Keyword, Whitespace, Name.Label)),
            (rf"{START}(all)([ \t]+)({'|'.join(w.PAIRS)}){END}", bygroups(Keyword, Whitespace, Keyword)),
            (rf"(^|;)([ \t]*)(counterweight)([ \t]+)({NAME})([ \t]+)(on)([ \t]+)({NAME})(?=[ \t]*\{{)", bygroups(Punctuation, Whitespace, Keyword, Whitespace, Name, Whitespace, Keyword.Reserved, Whitespace, Name), "counterweight"),
            (rf"{START}(balance)([ \t]+)(force|torque){END}", bygroups(Keyword, Whitespace, Keyword)),
            (head(w.STATEMENTS + w.PAIRS, "^|;") + NOT_HEAD, bygroups(Punctuation, Whitespace, Keyword)),
            (head(w.MEMBERS + w.CAM_MEMBERS, "^|[;{]") + NOT_HEAD, bygroups(Punctuation, Whitespace, Keyword.Reserved)),
            (head(w.PROPERTIES, "^|[;{]") + r"(?!\s*[(=,.\[])", bygroups(Punctuation, Whitespace, Name.Attribute)),
            (rf"{after('link', 'shaft', 'slider')}([0-9]+)([ \t]+)({NAME})", bygroups(Number, Whitespace, Name.Class)),
            (rf"{after('link', 'shaft', 'slider')}(?!(?:at|in|on){END}){NAME}", Name.Class),
            (rf"{after('fit', 'groove', 'bevel')}({'|'.join(w.VALUES)}){END}", Name.Constant),
            # names that may look like words: `line left through U`
            (rf"{after(*BEFORE_NAMES)}{NAME}", Name),
            (rf"{START}(at)([ \t]+)(event)(?=[ \t]+{LETTER})", bygroups(Keyword.Reserved, Whitespace, Keyword.Reserved)),
            (rf"{START}(over|under)(?=\()", Keyword.Reserved),
            (rf"{START}({NAME})(?=\s*:)", Name.Label),
            (rf"{START}(as)([ \t]+)([^\s,;}}]+)", bygroups(Keyword.Reserved, Whitespace, Keyword.Type)),
            (r"(\[)([ \t]*)([^\]\s]*)([ \t]*)(\])", bygroups(Punctuation, Whitespace, Keyword.Type, Whitespace, Punctuation)),
            (rf"{START}{NUMBER}[ \t]*{UNIT}", Number),
            (NUMBER, Number),
            (words(w.CONNECTING, prefix=START, suffix=END), Keyword.Reserved),
            (words(w.LAWS, prefix=START, suffix=END), Name.Constant),
            include("names"),
            (r"\.\.|<=|>=|[-+−–*/·⋅^@=<>]", Operator),
            (r"[()\[\]{},;:.]", Punctuation),
            (r"\n|[^\S\n]+", Whitespace),
        ],
        "counterweight": [
            (rf"(^|[{{;])([ \t]*)(radius|mass|plane){END}", bygroups(Punctuation, Whitespace, Name.Attribute)),
            (r"\}", Punctuation, "#pop"),
            include("root"),
        ],
        "names": [
            (rf"(?<!\.)({'|'.join(w.FUNCTIONS)}){END}(?=[ \t]*\()", Name.Builtin),
            (rf"(?<!\.)({'|'.join(w.COLLECTIONS)}){END}(?!\s*[(=.:])", Name.Builtin),
            (rf"pi{END}", Name.Constant),
            # of a part: behind a mass
            (rf"(?<!\.)(inertia){END}(?=[ \t]+(?!(?:{'|'.join(w.CONNECTING)}){END})[^\W_(])", Keyword.Reserved),
            # of a shape: behind a mass
            (rf"(?<!\.)(rod(?=[ \t]+{NAME}[ \t]+to{END})|(?:disc|ring|sphere)(?=[ \t]+centre{END})|plate(?=[ \t]+{NAME}[ \t]*,))", Keyword.Reserved),
            (rf"(?<!\.)(?<![-:] )(inner|thickness|section|plane){END}(?=[ \t]+(?!(?:{'|'.join(w.CONNECTING + w.CONTEXTUAL)}){END})[^\W_])", Keyword.Reserved),
            (rf"(?<!\.)(?<![-:] )({'|'.join(w.CONTEXTUAL)}){END}(?!\s*(?:[:=.,()+*/^]|-\s))", Keyword.Reserved),
            (NAME, Name),
        ],
    }
