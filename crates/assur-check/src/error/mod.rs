//! Errors of the meaning of a document: one enum per topic.

mod cam;
mod curve;
mod expect;
mod friction;
mod gear;
mod request;
mod simulate;
mod train;
mod unit;

pub use cam::CamError;
pub use curve::CurveError;
pub use expect::ExpectError;
pub use friction::FrictionError;
pub use gear::GearError;
pub use request::RequestError;
pub use simulate::SimulateError;
pub use train::TrainError;
pub use unit::UnitsError;
