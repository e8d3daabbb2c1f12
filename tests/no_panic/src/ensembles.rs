//! Many bodies at once, in registers of every width.

use newton_euler::ensemble::Ensemble;

use crate::kinds::*;
use crate::systems::DoublePendulum;

cannot_panic! {
    fn crafts(ensemble: &mut Ensemble<Craft<f64>>, start: f64, end: f64, steps: usize) -> () {
        ensemble.cf4(start..end, steps);
    }

    fn turning(ensemble: &mut Ensemble<Turning<f64>>, start: f64, end: f64, steps: usize) -> () {
        ensemble.cf4(start..end, steps);
    }

    fn planks(ensemble: &mut Ensemble<Plank<f64>>, start: f64, end: f64, steps: usize) -> () {
        ensemble.cf4(start..end, steps);
    }

    fn sticks(ensemble: &mut Ensemble<Stick<f64>>, start: f64, end: f64, steps: usize) -> () {
        ensemble.cf4(start..end, steps);
    }

    fn double_pendulums(ensemble: &mut Ensemble<DoublePendulum<f64>>, start: f64, end: f64, steps: usize) -> () {
        ensemble.cf4(start..end, steps);
    }
}
