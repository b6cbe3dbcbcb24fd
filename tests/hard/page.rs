//! docs/stability.md tells what the catalogue measures.
