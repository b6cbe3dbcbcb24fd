pub(super) const fn specs(_kind: crate::syntax::document::JointKind) -> &'static [super::property::Spec] {
    &[]
}
pub(super) fn transmission(
    _cx: &mut super::context::Context<'_>,
    _joint: &crate::syntax::document::Joint,
    _span: crate::source::Span,
) {
}
