//! Wrenches: resultants, changes of the pole, power; F04, F05, F17 and the dipole of F19.

use nalgebra::{Vector2, Vector3};
use newton_euler::prelude::*;
use proptest::prelude::*;
use serde_json::Value;

use crate::reference::{number, numbers, planar, statement, vector};

/// Forces at points, as the reference lists them.
fn forces(list: &Value) -> Vec<(Vector3<f64>, Vector3<f64>)> {
    let list = list.as_array().unwrap();
    list.iter()
        .map(|pair| (vector(&pair[0]), vector(&pair[1])))
        .collect()
}

/// F17.
#[test]
fn change_of_origin() {
    let expected = statement("F17 origin change");
    let forces = forces(&expected["f;r"]);
    let about = |pole: Vector3<f64>| -> Wrench {
        forces
            .iter()
            .map(|(f, r)| Wrench::from_force_at(*f, r - pole))
            .sum()
    };
    let [origin, a] = [Vector3::zeros(), vector(&expected["a"])];
    let wrench = about(origin);
    assert_eq!(wrench.force, vector(&expected["F"]));
    // Sums of six products up to 3.
    assert!((wrench.moment - vector(&expected["K"])).amax() < 2e-15);
    let primed = vector(&expected["K'"]);
    for other in [about(a), wrench.moved(&origin, &a)] {
        assert_eq!(other.force, wrench.force);
        assert!((other.moment - primed).amax() < 4e-15);
        assert!((other.moved(&a, &origin).moment - wrench.moment).amax() < 4e-15);
    }
}

/// F19 without net charge: the force vanishes and the moment is that of every pole.
#[test]
fn couple() {
    let expected = statement("F19 pure dipole, sum e=0");
    let [field, arm] = [vector(&expected["E"]), Vector3::new(0.03, -0.01, 0.02)];
    let pair = [0.002, -0.002].map(|e| Wrench::from_force_at(field * e, arm * (500.0 * e)));
    let dipole: Wrench = pair.into_iter().sum();
    assert_eq!(dipole.force, Vector3::zeros());
    assert!((dipole.moment - vector(&expected["K=p x E"])).amax() < 1e-17);
    assert_eq!(
        dipole.moved(&Vector3::zeros(), &Vector3::new(1e9, -2e9, 3e9)),
        dipole
    );
}

/// F04: the planar balances of a body with all eight families of loads.
#[test]
fn planar_residuals() {
    let expected = statement("F04 planar residuals (1.3),(1.4)");
    let scalar = |name: &str| number(&expected[name]);
    let [center, acceleration] = ["G", "aG"].map(|name| planar(&expected[name]));
    let couples = ["Mv", "Ms", "Mext", "Mf"].map(|name| number(&expected["torques"][name]));
    let residual = |pole: Vector2<f64>| -> PlanarWrench {
        let loads = ["Rv", "Fs", "Fext", "Ff"].map(|name| {
            let [force, at] = [0, 1].map(|k| planar(&expected["forces(F;P)"][name][k]));
            PlanarWrench::from_force_at(force, at - pole)
        });
        let inertial = PlanarWrench::from_force_at(-acceleration * scalar("m"), center - pole);
        let inertial = inertial + PlanarWrench::from_moment(-scalar("JG") * scalar("alpha"));
        let loads: PlanarWrench = loads.into_iter().sum();
        loads + couples.map(PlanarWrench::from_moment).into_iter().sum() + inertial
    };
    let [origin, far] = [Vector2::zeros(), Vector2::new(1e6, -2.5e6)];
    let about_center = residual(center);
    // Sums of numbers up to 44.
    assert!((about_center.force - planar(&expected["R"])).amax() < 2e-14);
    assert!((about_center.moment - scalar("M about G")).abs() < 2e-14);
    for (pole, name, tolerance) in [
        (origin, "M about origin", 2e-14),
        (far, "M about far pole (1e6,-2.5e6)", 1e-7), // 1e8 in forces at 1e6: eps times that
    ] {
        assert!((residual(pole).moment - scalar(name)).abs() < tolerance);
        assert!((about_center.moved(&center, &pole).moment - scalar(name)).abs() < tolerance);
    }
}

/// F05: no term in the velocity of the pole in (1.4), one in the derivative of the angular momentum.
#[test]
fn moving_pole() {
    let expected = statement("F05 moving pole");
    let [mass, inertia, acceleration] = [2.0, 0.35, 1.9];
    let [center, velocity, center_acceleration] =
        [[0.6, 0.2], [1.5, -0.4], [0.7, 2.1]].map(Vector2::from);
    let [pole, pole_velocity] = [[-0.3, 0.9], [-2.0, 0.8]].map(Vector2::from);
    let balancing = PlanarWrench::from_force_at(center_acceleration * mass, center - pole)
        + PlanarWrench::from_moment(inertia * acceleration);
    let momentum = velocity * mass;
    let derivative = balancing.moment - pole_velocity.perp(&momentum);
    assert!(
        (balancing.moment - number(&expected["M_O (=-inertial moment about O)"])).abs() < 4e-15
    );
    assert!((derivative - number(&expected["dL_O/dt"])).abs() < 4e-15);
    // The derivative by differences of L_O = J ω + (G - O) × m v_G, a parabola in time: exact but for rounding.
    let spin = 0.7;
    let angular_momentum = |t: f64| {
        let arm =
            center + velocity * t + center_acceleration * (t * t / 2.0) - pole - pole_velocity * t;
        inertia * (spin + acceleration * t)
            + arm.perp(&((velocity + center_acceleration * t) * mass))
    };
    let h = 1e-3;
    let difference = (angular_momentum(h) - angular_momentum(-h)) / (2.0 * h);
    assert!((difference - derivative).abs() < 1e-5); // the cubic term, h² times 2
}

/// F03: the planar inertial wrench about another pole.
#[test]
fn inertial_wrench_about_a_pole() {
    let expected = statement("F01-03 planar inertia wrench");
    let [x, y] = numbers(&expected["F_iG by summation"]);
    let about_center = PlanarWrench {
        force: Vector2::new(x, y),
        moment: number(&expected["M_iG by summation"]),
    };
    let moved = about_center.moved(&Vector2::new(0.5, 0.25), &Vector2::new(3.2, -1.1));
    let name = "pole O=(3.2,-1.1), G=(0.5,0.25): M_iO = M_iG + (G-O)xF_iG";
    assert!((moved.moment - number(&expected[name])).abs() < 2e-14);
}

fn some_vector() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-1.0..1.0).prop_map(Vector3::from)
}

proptest! {
    /// The power is that of the forces on the points of a moving body, and of every pole.
    #[test]
    fn power(
        loads in prop::collection::vec((some_vector(), some_vector()), 1..6),
        couple in some_vector(),
        velocity in some_vector(), // of the point at the origin
        w in some_vector(),
        pole in some_vector(),
    ) {
        let wrench = Wrench::from_moment(couple)
            + loads.iter().map(|(f, r)| Wrench::from_force_at(*f, *r)).sum();
        let expected = couple.dot(&w)
            + loads.iter().map(|(f, r)| f.dot(&(velocity + w.cross(r)))).sum::<f64>();
        let moved = wrench.moved(&Vector3::zeros(), &pole);
        // Sums of fifty numbers below 6.
        prop_assert!((wrench.power(&velocity, &w) - expected).abs() < 1e-13);
        prop_assert!((moved.power(&(velocity + w.cross(&pole)), &w) - expected).abs() < 1e-13);
    }

    /// The plane is a plane of space.
    #[test]
    fn planar_is_spatial(f in some_vector(), r in some_vector(), pole in some_vector(), w in -1.0..1.0) {
        let flat = |v: &Vector3<f64>| Vector3::new(v.x, v.y, 0.0);
        let spatial = Wrench::from_force_at(flat(&f), flat(&r)).moved(&Vector3::zeros(), &flat(&pole));
        let planar = PlanarWrench::from_force_at(f.xy(), r.xy()).moved(&Vector2::zeros(), &pole.xy());
        prop_assert_eq!(planar.force, spatial.force.xy());
        prop_assert!((planar.moment - spatial.moment.z).abs() < 1e-15);
        let powers = planar.power(&r.xy(), w) - spatial.power(&flat(&r), &(Vector3::z() * w));
        prop_assert!(powers.abs() < 1e-15);
    }

    #[test]
    fn sums(f in some_vector(), r in some_vector(), k in some_vector()) {
        let [a, b] = [Wrench::from_force_at(f, r), Wrench::from_moment(k)];
        let mut sum = a;
        sum += b;
        prop_assert_eq!(sum, a + b);
        prop_assert_eq!(a - a, Wrench::default());
        prop_assert_eq!(-(a - b), b - a);
        prop_assert_eq!([a, b].into_iter().sum::<Wrench>(), Wrench::default() + a + b);
    }
}
