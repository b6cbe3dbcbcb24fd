//! English.

use super::RunMessage as Message;

pub(super) const fn template(message: Message) -> &'static str {
    match message {
        Message::Run => "Motion under the loads",
        Message::EnergyHere => "The kinetic energy at this instant, Σ ½ m v² + ½ J ω²:",
        Message::Reduced => {
            "Reduced to the free coordinate (index r): all masses have the kinetic energy of the reduced one, all loads the power of the reduced one:"
        }
        Message::ReducedMotion => {
            "The reduced load accelerates the reduced mass; what is left of it (index Δ) is half the change of the reduced mass along the coordinate times the square of its rate:"
        }
        Message::EnergyOfRun => {
            "Over the whole run the kinetic energy changes by the work W of all loads, weights and springs (Δ is what is left):"
        }
        Message::EventsOfRun => "Events of the run:",
        Message::Event => "Event",
        Message::Instants => "Instants, s",
        Message::RunMethod => {
            "The equations of motion were integrated by {0} in {1} steps ({2} evaluations); the estimated error is {3} of the greatest value of its kind."
        }
        Message::ByEnergy => "energy and quadrature",
        Message::ReducedSeveral => {
            "What mass centres and links move per unit rate of one free coordinate, the others at rest (k, the coordinate behind the comma), gives the reduced masses:"
        }
        Message::EnergyReduced => "By these the kinetic energy is the same:",
    }
}
