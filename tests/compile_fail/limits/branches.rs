use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    forces: [
        push = body(
            0,
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else if t < 1 { 1 } else
            { 2 }
        ),
    ],
});

fn main() {}
