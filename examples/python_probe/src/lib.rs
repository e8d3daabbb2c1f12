//! A body as a Python module, built into a wheel by maturin:
//!
//! ```sh
//! pip install maturin
//! maturin build --release --manifest-path examples/python_probe/Cargo.toml --out wheels
//! pip install wheels/probe-*.whl && python examples/python_probe/check.py
//! ```

use newton_euler::columns::Named as _;
use newton_euler::prelude::*;
use newton_euler::state::Coordinates as _;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

mod body {
    use newton_euler::rigid_body;

    rigid_body!(Probe {
        doc: "A spinning probe with an off-axis engine.",
        motion: spatial,
        params: [offset = 2[cm]],
        inputs: [thrust[N]],
        mass: 85[kg],
        inertia: principal(12, 12, 20)[kg * m ^ 2],
        points: [nozzle = (offset, 0, -0.6[m])],
        forces: [engine = body(0, 0, thrust).at(nozzle)],
        fields: [weight = mass * world(0, 0, -1.62[m / s ^ 2])],
    });
}

/// A state as a list of numbers; `Probe.columns()` names them.
type Row = [f64; 13];

/// A spinning probe with an off-axis engine.
#[pyclass]
struct Probe(body::Probe);

fn value_error(error: impl std::fmt::Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}

#[pymethods]
impl Probe {
    #[new]
    #[pyo3(signature = (offset = 0.02))]
    fn new(offset: f64) -> PyResult<Self> {
        let probe = body::Probe::new(body::ProbeParams { offset });
        probe.map(Self).map_err(value_error)
    }

    /// The names of the numbers of a state.
    #[staticmethod]
    fn columns() -> Vec<String> {
        Spatial::NAMES
            .to_string()
            .split(',')
            .map(String::from)
            .collect()
    }

    /// The equations of motion.
    #[staticmethod]
    fn equations() -> &'static str {
        body::Probe::EQUATIONS
    }

    /// Times and states at equal intervals, under a constant thrust.
    fn samples(&self, start: Row, thrust: f64, end: f64, period: f64) -> PyResult<Vec<(f64, Row)>> {
        let start = Spatial::from_coordinates(&start);
        if (start.attitude.norm() - 1.0).abs() > 1e-9 {
            return Err(PyValueError::new_err(
                "an attitude is a unit quaternion x, y, z, w",
            ));
        }
        let motion = self.0.integrate(&start).input(body::ProbeInput { thrust });
        let samples = motion.samples(end, period).map(|sample| {
            let sample = sample.map_err(value_error)?;
            Ok((sample.time, sample.state.coordinates()))
        });
        samples.collect()
    }
}

/// A body that moves by newton-euler.
#[pymodule]
fn probe(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Probe>()
}
