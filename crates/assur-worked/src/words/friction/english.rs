//! English.

use super::FrictionMessage as Message;

pub(super) const fn template(message: Message) -> &'static str {
    match message {
        Message::FrictionFirst => "With these values friction is a known load, and equilibrium is linear:",
        Message::FrictionLaws => "The law of friction with the reactions found gives the same friction:",
        Message::PairStill => "Nothing slides in pair {0}: no friction.",
        Message::PairHeld => {
            "Friction holds pair {0}: {1} is found with the accelerations, so that its links do not move against each other."
        }
        Message::PairHeldByBalance => "Friction holds pair {0}; {1} follows from the balance.",
        Message::ContactPoint => "{0} is the point where the links of {1} touch.",
        Message::RestsOnStop => "Pair {0} rests on its stop, which pushes with {1} along its coordinate.",
        Message::HoldTurn => {
            "Link {0}: no effort acts on this free coordinate, so that moments about {1} give {2}:"
        }
        Message::HoldShift => {
            "Link {0}: no effort acts on this free coordinate, so that forces along the guide give {1}:"
        }
        Message::FrictionDirect => {
            "The normal force in this pair depends on the loads alone, not on friction. The sense of the friction:"
        }
        Message::FrictionSenses => "Friction in the pairs of this group opposes the relative motion:",
        Message::PairMovesPositive => {
            "Pair {0}: link {1} moves relative to link {2} with {3} > 0, so {4} on link {1} is negative."
        }
        Message::PairMovesNegative => {
            "Pair {0}: link {1} moves relative to link {2} with {3} < 0, so {4} on link {1} is positive."
        }
        Message::PairBeginsPositive => {
            "Pair {0} begins to move: the relative acceleration of link {1} is positive, so {2} on link {1} is negative."
        }
        Message::PairBeginsNegative => {
            "Pair {0} begins to move: the relative acceleration of link {1} is negative, so {2} on link {1} is positive."
        }
        Message::PairOnGroundPositive => {
            "Pair {0}: link {1} moves relative to the ground with {2} > 0, so {3} on link {1} is negative."
        }
        Message::PairOnGroundNegative => {
            "Pair {0}: link {1} moves relative to the ground with {2} < 0, so {3} on link {1} is positive."
        }
        Message::FrictionSteps => {
            "Step 0 has the reactions without friction. Every other step takes the lines of action parallel to the last ones and tangent to the friction circles (in guides: on the side that presses). Equilibrium is then linear and gives new reactions. The last column is the greatest change of a reaction over the greatest reaction:"
        }
        Message::FrictionSearched => {
            "This iteration of one group leads to no motion. The laws of all pairs were then solved together for every combination of pressing sides; the values below are those of the solution found."
        }
        Message::Change => "Change",
        Message::Losses => "Losses and efficiency",
        Message::PairsLose => "Every pair loses the power of its friction:",
        Message::WithoutFriction => {
            "Without friction (index 0) the powers of the loads and the efforts add up to zero:"
        }
        Message::EffortsDrive => {
            "The efforts drive: the efficiency is their power without friction over that with it."
        }
        Message::EffortsResist => {
            "The efforts resist: the efficiency is their power with friction over that without it."
        }
        Message::NotLocked => "η > 0: the mechanism moves in this sense and does not lock.",
        Message::LocksItself => {
            "η ≤ 0: the loads alone cannot move the mechanism in this sense (self-locking); the efforts must help."
        }
        Message::OnlyFriction => {
            "Without friction the efforts would have nothing to do: they overcome friction alone, and the efficiency is 0."
        }
        Message::LocksFrom => "Locking begins, or ends, at {0} = {1}.",
        Message::Locked => {
            "With this friction no finite effort moves the mechanism: the laws of friction and equilibrium have no solution with the senses of this motion. It is locked, and its efficiency is 0."
        }
        Message::FrictionShares => {
            "Friction holds the mechanism at rest in more pairs than it takes. How they share the loads is not determined, and neither are the reactions."
        }
        Message::FrictionSharesHere => {
            "Friction holds these links in more pairs than it takes. How the pairs share the loads is not determined, and neither are the reactions here."
        }
    }
}
