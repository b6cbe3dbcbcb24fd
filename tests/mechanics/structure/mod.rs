//! Verdicts on structure: the files of use with what is wanted of each, and random linkages against the rank of the
//! equations of velocity at random dimensions.

mod agrees;
mod cases;
mod help;
mod lines;
mod linkage;
mod mends;
mod oracle;
mod random_linkages;
mod surplus;
