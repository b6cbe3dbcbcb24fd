//! Every code there is, with its page.

/// A code and the page that explains it.
#[derive(Clone, Copy, Debug)]
pub struct Code {
    /// `mech::<stage>::<what_is_wrong>`
    pub code: &'static str,
    /// The page, in Markdown: what it means, why it matters, an example and its fix.
    pub page: &'static str,
}

/// A row is a stage and a name; its page is `docs/explain/<stage>/<name>.md`.
macro_rules! codes {
    ($($stage:literal / $name:literal,)*) => {
        &[$(Code {
            code: concat!("mech::", $stage, "::", $name),
            page: include_str!(concat!("../../docs/explain/", $stage, "/", $name, ".md")),
        }),*]
    };
}

/// All codes, in the order of the stages.
pub const CODES: &[Code] = codes! {
    // syntax
    "syntax" / "empty_file",
    "syntax" / "full_width",
    "syntax" / "curly_quotes",
    "syntax" / "foreign_sign",
    "syntax" / "invisible_character",
    "syntax" / "lone_carriage_return",
    "syntax" / "too_deep",
    "syntax" / "bare_decimal_point",
    "syntax" / "number_too_large",
    "syntax" / "decimal_comma",
    "syntax" / "brace_on_its_own_line",
    "syntax" / "missing_brace",
    "syntax" / "unclosed_bracket",
    "syntax" / "unmatched_bracket",
    "syntax" / "equals_expected",
    "syntax" / "colon_expected",
    "syntax" / "unclosed_text",
    "syntax" / "title_without_quotes",
    "syntax" / "title_twice",
    "syntax" / "unknown_edition",
    "syntax" / "edition_not_first",
    "syntax" / "unit_in_row",
    "syntax" / "misspelt_word",
    "syntax" / "unknown_statement",
    "syntax" / "misplaced_member",
    "syntax" / "reserved_name",
    "syntax" / "two_statements",
    "syntax" / "missing_word",
    "syntax" / "missing_operator",
    "syntax" / "third_coordinate",
    "syntax" / "comment_sign",
    "syntax" / "point_without_coordinates",
    "syntax" / "unexpected",
    "syntax" / "other_word",
    "syntax" / "needless_sign",
    "syntax" / "comma_between",
    "syntax" / "without_brackets",
    "syntax" / "digit_first",
    // check
    "geometry" / "not_positive",
    "geometry" / "negative",
    "geometry" / "stated_twice",
    "geometry" / "point_does_not_close",
    "geometry" / "same_place",
    "geometry" / "circular_points",
    "geometry" / "mass_without_place",
    "geometry" / "weight_without_gravity",
    "geometry" / "inertia_too_small",
    "geometry" / "point_mass",
    "geometry" / "nothing_to_join",
    "geometry" / "wrong_ends",
    "geometry" / "joined_with_itself",
    "geometry" / "joined_twice",
    "geometry" / "held_twice",
    "geometry" / "no_contact",
    "geometry" / "unknown_property",
    "geometry" / "property_value",
    "geometry" / "incomplete",
    "geometry" / "contacts_coincide",
    "geometry" / "no_group",
    "geometry" / "driven_twice",
    "geometry" / "no_coordinate",
    "geometry" / "on_ground",
    "geometry" / "wrong_sense",
    "geometry" / "acceleration_without_speed",
    "geometry" / "drive_without_position",
    "geometry" / "steps",
    "geometry" / "positions_differ",
    "geometry" / "not_driven",
    "geometry" / "pose_incomplete",
    "geometry" / "pose_of_sweep",
    "geometry" / "no_guide",
    "geometry" / "near_with_dead",
    "geometry" / "no_single_point",
    "geometry" / "no_direction",
    "geometry" / "force_without_place",
    "geometry" / "force_without_direction",
    "geometry" / "load_form",
    "geometry" / "wrong_effort",
    "geometry" / "depends_on_forces",
    "name" / "unknown",
    "name" / "wrong_kind",
    "name" / "duplicate",
    "name" / "look_alike",
    "name" / "cycle",
    "name" / "ambiguous_point",
    "unit" / "unknown",
    "unit" / "missing",
    "unit" / "mismatch",
    "unit" / "operands",
    "unit" / "hertz",
    "unit" / "shape",
    "unit" / "power",
    "unit" / "no_value",
    "unit" / "also_a_name",
    "request" / "not_constant",
    "request" / "needs_pose",
    "request" / "arguments",
    "request" / "argument",
    "request" / "which_link",
    "request" / "link_not_in_pair",
    "request" / "not_of_this_pair",
    "request" / "which_two",
    "request" / "no_contacts",
    "request" / "no_mass",
    "request" / "not_driven",
    "request" / "no_own_effort",
    "request" / "too_long",
    "request" / "which_drive",
    "request" / "no_value",
    "request" / "part",
    "request" / "asked_twice",
    "request" / "variant_row",
    "request" / "set_unknown",
    "request" / "set_value",
    "expect" / "no_value",
    "expect" / "truth",
    "expect" / "tolerance_of_truth",
    "expect" / "zero",
    "expect" / "no_tolerance",
    "expect" / "tolerance",
    "expect" / "tolerance_unit",
    "expect" / "which_pose",
    "expect" / "count",
    "expect" / "list_at_pose",
    "expect" / "unknown_pose",
    "friction" / "no_motion",

    // structure
    "determinacy" / "floating_link",
    "determinacy" / "not_grounded",
    "determinacy" / "outer_link",
    "determinacy" / "underconstrained",
    "determinacy" / "overconstrained",
    "determinacy" / "repeated",
    "determinacy" / "unbalanced",
    "determinacy" / "efforts",
    "determinacy" / "not_a_group",
    "determinacy" / "part_of_larger",
    "determinacy" / "contains_smaller",

    // plan

    // solve
    "friction" / "locked",
    "friction" / "no_effort",
    "friction" / "no_sliding",

    // element

    // exercise
    "expect" / "mismatch",
    "expect" / "pose_failed",
    "expect" / "undefined",
};

/// The page of a code; the leading `mech::` may be left out.
#[must_use]
pub fn explain(code: &str) -> Option<&'static str> {
    let wanted = code.strip_prefix("mech::").unwrap_or(code);
    CODES.iter().find(|c| c.code.strip_prefix("mech::") == Some(wanted)).map(|c| c.page)
}
