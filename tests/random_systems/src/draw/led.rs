//! Motions of joints that user-defined states prescribe.

use std::rc::Rc;

use super::number::{Numbers, literal};
use crate::law::scene::{Instant, Prescribed};
use crate::wide::Wide;

/// What a state that drives a joint changes by.
pub struct Led {
    pub state: usize,
    pub word: String,
    pub rate: Rc<dyn Fn(&Instant<'_>) -> Wide>,
}

impl Numbers {
    /// A function of a state.
    pub fn led(&mut self, unit: &str) -> (String, Prescribed) {
        let value = self.plain(1.0);
        let (name, place) = self.state(value, unit);
        let path = self.path(unit, place);
        let factor = self.plain(1.0);
        match self.rng.usize(0..3) {
            0 => (name, path),
            1 => {
                let (word, factor) = self.quantity(factor, "");
                let function: Prescribed = Box::new(move |at| path(at).map(|part| factor * part));
                (format!("{word} * {name}"), function)
            }
            _ => {
                let (word, factor) = self.quantity(factor, unit);
                let function: Prescribed = Box::new(move |at| {
                    let [x, v, a] = path(at);
                    let (sine, cosine) = x.sin_cos();
                    let slope = Wide::ONE + factor * cosine;
                    [
                        x + factor * sine,
                        v * slope,
                        a * slope - factor * sine * v * v,
                    ]
                });
                (
                    format!("{name} + {word} * ({name} / 1[{unit}]).sin()"),
                    function,
                )
            }
        }
    }

    /// How a state moves: by the time, after a moving input, or as fast as another state that follows
    /// an input at once or swings.
    fn path(&mut self, unit: &str, place: usize) -> Prescribed {
        let (size, pace) = (self.plain(1.0), self.positive(3.0));
        let (pace_word, k) = self.quantity(pace, "1 / s");
        let which = self.rng.usize(0..4);
        if which == 0 {
            let (word, size) = self.quantity(size, &format!("{unit} / s"));
            let word = format!("{word} * ({pace_word} * t).cos()");
            let wave = move |at: &Instant<'_>| {
                let (sine, cosine) = (k * at.time).sin_cos();
                [size * cosine, -(size * k * sine)]
            };
            self.leads(place, word, move |at| wave(at)[0]);
            return moving(place, wave);
        }
        if which == 1 {
            let (input, number) = self.moving(unit);
            let word = format!("{pace_word} * ({input} - s{place})");
            let lag = move |at: &Instant<'_>| {
                let rate = k * (at.inputs[number] - at.states[place]);
                [rate, k * (at.inputs[number + 1] - rate)]
            };
            self.leads(place, word, move |at| lag(at)[0]);
            return moving(place, lag);
        }
        let fast = format!("{unit} / s");
        let value = self.plain(2.0);
        let (speed, second) = self.state(value, &fast);
        self.leads(place, speed.clone(), move |at| at.states[second]);
        if which == 2 {
            let (input, number) = self.input(&fast);
            let word = format!("{pace_word} * ({input} - {speed})");
            let rate = move |at: &Instant<'_>| k * (at.inputs[number] - at.states[second]);
            self.leads(second, word, rate);
            return moving(place, move |at| [at.states[second], rate(at)]);
        }
        let word = format!(
            "-{}[1 / s ^ 2] * s{place} - {pace_word} * {speed}",
            literal(size.abs())
        );
        let rate = move |at: &Instant<'_>| {
            -(at.states[place] * Wide::from(size.abs()) + k * at.states[second])
        };
        self.leads(second, word, rate);
        moving(place, move |at| [at.states[second], rate(at)])
    }

    fn leads(&mut self, state: usize, word: String, rate: impl Fn(&Instant<'_>) -> Wide + 'static) {
        let rate = Rc::new(rate);
        self.declared.led.push(Led { state, word, rate });
    }
}

/// A state with its rate and acceleration.
fn moving(place: usize, rates: impl Fn(&Instant<'_>) -> [Wide; 2] + 'static) -> Prescribed {
    Box::new(move |at| {
        let [rate, acceleration] = rates(at);
        [at.states[place], rate, acceleration]
    })
}
