//! Signs as LaTeX prints them in any of its font encodings, without a package.

/// Writes a sign. Letters that are not in the table stay; another sign that is not in it becomes its code, `U+2318`.
pub(super) fn write(c: char, out: &mut String) {
    match c {
        '{' | '}' | '$' | '&' | '#' | '_' | '%' => {
            out.push('\\');
            out.push(c);
        }
        _ => match SIGNS.iter().find(|(sign, _)| *sign == c) {
            Some((_, written)) => *out += written,
            None if c.is_ascii() || c.is_alphabetic() => out.push(c),
            None => *out += &format!("U+{:04X}", u32::from(c)),
        },
    }
}

/// The accent in formulas of a mark that stands over the letter before it.
pub(super) const fn accent(mark: char) -> Option<&'static str> {
    match mark {
        '\u{300}' => Some("grave"),
        '\u{301}' => Some("acute"),
        '\u{302}' => Some("hat"),
        '\u{303}' => Some("tilde"),
        '\u{304}' | '\u{305}' => Some("bar"),
        '\u{306}' => Some("breve"),
        '\u{307}' => Some("dot"),
        '\u{308}' => Some("ddot"),
        '\u{30C}' => Some("check"),
        '\u{20D7}' => Some("vec"),
        _ => None,
    }
}

/// Signs and what LaTeX reads for them.
#[rustfmt::skip]
const SIGNS: &[(char, &str)] = &[
    ('\\', "\\textbackslash{}"), ('~', "\\textasciitilde{}"), ('^', "\\textasciicircum{}"),
    ('<', "\\textless{}"), ('>', "\\textgreater{}"), ('|', "$|$"), ('"', "\\symbol{34}"),
    // Greek letters
    ('α', "$\\alpha$"), ('β', "$\\beta$"), ('γ', "$\\gamma$"), ('δ', "$\\delta$"), ('ε', "$\\varepsilon$"),
    ('ϵ', "$\\epsilon$"), ('ζ', "$\\zeta$"), ('η', "$\\eta$"), ('θ', "$\\theta$"), ('ϑ', "$\\vartheta$"),
    ('ι', "$\\iota$"), ('κ', "$\\kappa$"), ('λ', "$\\lambda$"), ('µ', "$\\mu$"), ('μ', "$\\mu$"),
    ('ν', "$\\nu$"), ('ξ', "$\\xi$"), ('ο', "$o$"), ('π', "$\\pi$"), ('ρ', "$\\rho$"), ('ϱ', "$\\varrho$"),
    ('σ', "$\\sigma$"), ('ς', "$\\varsigma$"), ('τ', "$\\tau$"), ('υ', "$\\upsilon$"), ('φ', "$\\varphi$"),
    ('ϕ', "$\\phi$"), ('χ', "$\\chi$"), ('ψ', "$\\psi$"), ('ω', "$\\omega$"),
    ('Α', "A"), ('Β', "B"), ('Γ', "$\\Gamma$"), ('Δ', "$\\Delta$"), ('∆', "$\\Delta$"), ('Ε', "E"), ('Ζ', "Z"),
    ('Η', "H"), ('Θ', "$\\Theta$"), ('Ι', "I"), ('Κ', "K"), ('Λ', "$\\Lambda$"), ('Μ', "M"), ('Ν', "N"),
    ('Ξ', "$\\Xi$"), ('Ο', "O"), ('Π', "$\\Pi$"), ('∏', "$\\prod$"), ('Ρ', "P"), ('Σ', "$\\Sigma$"),
    ('∑', "$\\sum$"), ('Τ', "T"), ('Υ', "$\\Upsilon$"), ('Φ', "$\\Phi$"), ('Χ', "X"), ('Ψ', "$\\Psi$"),
    ('Ω', "$\\Omega$"), ('\u{2126}', "$\\Omega$"), ('ℓ', "$\\ell$"),
    // letters with dots, in rates
    ('ẇ', "$\\dot{w}$"), ('ẅ', "$\\ddot{w}$"), ('ṡ', "$\\dot{s}$"), ('ġ', "$\\dot{g}$"), ('ẋ', "$\\dot{x}$"),
    ('ẍ', "$\\ddot{x}$"), ('ẏ', "$\\dot{y}$"), ('ÿ', "$\\ddot{y}$"), ('ṙ', "$\\dot{r}$"), ('ż', "$\\dot{z}$"),
    // arithmetic and comparison
    ('−', "$-$"), ('±', "$\\pm$"), ('∓', "$\\mp$"), ('·', "$\\cdot$"), ('⋅', "$\\cdot$"), ('∙', "$\\bullet$"),
    ('×', "$\\times$"), ('∗', "$\\ast$"), ('÷', "$\\div$"), ('∕', "/"), ('⁄', "/"), ('√', "$\\surd$"),
    ('≤', "$\\le$"), ('⩽', "$\\le$"), ('≥', "$\\ge$"), ('⩾', "$\\ge$"), ('≪', "$\\ll$"), ('≫', "$\\gg$"),
    ('≈', "$\\approx$"), ('≠', "$\\ne$"), ('≡', "$\\equiv$"), ('≅', "$\\cong$"), ('∼', "$\\sim$"),
    ('∝', "$\\propto$"), ('∞', "$\\infty$"), ('∂', "$\\partial$"), ('∇', "$\\nabla$"), ('∫', "$\\int$"),
    ('∠', "$\\angle$"), ('⊥', "$\\perp$"), ('∥', "$\\parallel$"), ('‖', "$\\|$"), ('∩', "$\\cap$"),
    ('∪', "$\\cup$"), ('∈', "$\\in$"), ('∅', "$\\emptyset$"), ('⌀', "$\\oslash$"), ('¬', "$\\neg$"),
    ('∧', "$\\wedge$"), ('∨', "$\\vee$"), ('°', "$^\\circ$"), ('º', "$^o$"), ('ª', "$^a$"),
    ('′', "$'$"), ('″', "$''$"), ('‴', "$'''$"), ('½', "$\\frac{1}{2}$"), ('¼', "$\\frac{1}{4}$"),
    ('¾', "$\\frac{3}{4}$"),
    // arrows
    ('→', "$\\rightarrow$"), ('←', "$\\leftarrow$"), ('↔', "$\\leftrightarrow$"), ('↑', "$\\uparrow$"),
    ('↓', "$\\downarrow$"), ('↦', "$\\mapsto$"), ('⇒', "$\\Rightarrow$"), ('⇐', "$\\Leftarrow$"),
    ('⇔', "$\\Leftrightarrow$"), ('↻', "(cw)"), ('↺', "(ccw)"),
    // raised and lowered
    ('⁰', "$^0$"), ('¹', "$^1$"), ('²', "$^2$"), ('³', "$^3$"), ('⁴', "$^4$"), ('⁵', "$^5$"), ('⁶', "$^6$"),
    ('⁷', "$^7$"), ('⁸', "$^8$"), ('⁹', "$^9$"), ('⁺', "$^+$"), ('⁻', "$^-$"), ('ⁱ', "$^i$"), ('ⁿ', "$^n$"),
    ('ˢ', "$^s$"), ('ᵀ', "$^T$"),
    ('₀', "$_0$"), ('₁', "$_1$"), ('₂', "$_2$"), ('₃', "$_3$"), ('₄', "$_4$"), ('₅', "$_5$"), ('₆', "$_6$"),
    ('₇', "$_7$"), ('₈', "$_8$"), ('₉', "$_9$"), ('₊', "$_+$"), ('₋', "$_-$"), ('ₐ', "$_a$"), ('ₑ', "$_e$"),
    ('ᵢ', "$_i$"), ('ⱼ', "$_j$"), ('ₖ', "$_k$"), ('ₘ', "$_m$"), ('ₙ', "$_n$"), ('ᵣ', "$_r$"), ('ₓ', "$_x$"),
    // punctuation
    ('—', "---"), ('–', "--"), ('‒', "--"), ('‐', "-"), ('\u{2011}', "-"), ('…', "\\dots{}"), ('•', "$\\bullet$"),
    ('“', "``"), ('”', "''"), ('„', ",,"), ('‟', "``"), ('‘', "`"), ('’', "'"), ('‚', ","), ('«', "$\\ll$"),
    ('»', "$\\gg$"), ('‹', "$<$"), ('›', "$>$"), ('\u{A0}', "~"), ('\u{2009}', "\\,"), ('\u{202F}', "\\,"),
    ('§', "\\S{}"), ('¶', "\\P{}"), ('©', "\\copyright{}"), ('£', "\\pounds{}"),
];
