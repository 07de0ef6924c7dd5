//! Progressive failure of joints: bodies whose points have a history, in frictional contact with others.

mod body;
mod damage;
mod energy;
mod error;
mod follow;
mod gauge;
mod increment;
mod joint;
mod operator;
mod record;
mod state;

pub use body::{JointBody, ProgressiveBody};
pub use damage::{PlyDamage, PlyEvent, PlyEventKind, damage_map};
pub use error::{Halt, JointError};
pub use gauge::{Gauge, Mark, Pull};
pub use joint::{Joint, Options};
pub use record::{Ending, JointHistory, JointRecord};
pub use state::{BodyState, Energy, JointState};
