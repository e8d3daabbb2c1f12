use newton_euler::prelude::*;

rigid_body!(Rock {
    motion: spatial,
    params: [side = 1[m]],
    mass: 2[kg],
    inertia: cuboid(side, side, 2),
});

fn main() {
    let (rock, state) = (Rock::default(), Spatial::default());
    let acceleration = rock.acceleration(0.0, &state, &());
    let _ = rock.applied(0.0, &state, &());
    let _ = rock.kinetic_energy(&state);
    let _ = rock.linear_momentum(&state);
    let _ = rock.reactions(0.0, &state, &());
    let _ = rock.inverse(0.0, &state, &acceleration, &());
    let _ = rock.regressor(0.0, &state, &acceleration, &());
    let _ = Rock::PARAMETERS;
    let _ = rock.flow(&state, 1.0);
    let _ = rock.series::<5>(0.0, &state, &());
    let _ = rock.linearize(0.0, &state, &());
    let _ = rock.sensitivity(0.0, &state, &());
    let _ = rock.trim(&state);
}
