//! Trains with several freedoms, and wheels beside a linkage, against their kinetic energy by hand.
