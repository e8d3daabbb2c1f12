//! What the documentation of a body says about its inertia and its charges.

use proc_macro2::TokenStream;
use quote::quote;

use crate::{expand_description, pretty};
use mounted::expand::expand_system;

/// The lines under "Inertia about G:".
fn class(inertia: TokenStream) -> Vec<String> {
    of(
        "Inertia about G:",
        quote!(Body { motion: rotation, mass: 3, inertia: #inertia }),
    )
}

/// The list under a heading.
fn of(heading: &str, description: TokenStream) -> Vec<String> {
    let expansion = pretty(description);
    let lines = expansion.lines().skip_while(|line| !line.contains(heading));
    lines
        .skip(1)
        .map_while(|line| line.trim_start().strip_prefix("/// - "))
        .map(str::to_owned)
        .collect()
}

#[test]
fn spheres_and_cubes() {
    assert_eq!(class(quote!(sphere(0.5))), ["spherical: 0.3 kg m^2"]);
    let cube = quote!(cuboid(0.2, 0.2, 0.2).turned(body(1, 2, 3), 1));
    assert_eq!(class(cube), ["spherical: 0.02 kg m^2"]);
}

#[test]
fn an_axis_of_symmetry() {
    assert_eq!(
        class(quote!(cylinder(0.1, 0.7).along(body(0, 3, 4)))),
        ["symmetric about n = (0, 0.6, 0.8), prolate: 0.015 kg m^2 about n, 0.13 across"]
    );
    assert_eq!(
        class(quote!(disc(0.2).along(body(-1, 0, 0)))),
        [
            "symmetric about n = (1, 0, 0), oblate: 0.06 kg m^2 about n, 0.03 across",
            "planar: all mass is in the plane normal to n"
        ]
    );
    assert_eq!(
        class(quote!(principal(2, 0.001, 2))),
        [
            "symmetric about n = (0, 1, 0), prolate: 0.001 kg m^2 about n, 2 across",
            "like a rod: less than 1/1000 of the largest moment is about n"
        ]
    );
}

#[test]
fn three_moments() {
    assert_eq!(
        class(quote!(principal(1.5, 1, 2.5))),
        [
            "general: three different principal moments",
            "1 kg m^2 about (0, 1, 0)",
            "1.5 kg m^2 about (1, 0, 0)",
            "2.5 kg m^2 about (0, 0, 1)",
            "planar: all mass is in the plane normal to the axis of the largest moment"
        ]
    );
    // eigenvalues 1 and 3 of a block [[2, 1], [1, 2]], and one between
    assert_eq!(
        class(quote!(tensor {
            xx: 2,
            yy: 2,
            zz: 2.5,
            xy: 1
        })),
        [
            "general: three different principal moments",
            "1 kg m^2 about (0.7071067811865476, -0.7071067811865476, 0)",
            "2.5 kg m^2 about (0, 0, 1)",
            "3 kg m^2 about (0.7071067811865476, 0.7071067811865476, 0)"
        ]
    );
    let blade = class(quote!(principal(1, 1e-4, 1.00005)));
    assert_eq!(
        blade.last().map(String::as_str),
        Some(
            "like a rod: less than 1/1000 of the largest moment is about the axis of the least moment"
        )
    );
}

/// H1: a little thicker than what is refused as a rod.
#[test]
fn a_thin_body_is_a_body() {
    assert_eq!(class(quote!(principal(1.001e-9, 1, 1))).len(), 2);
    assert_eq!(class(quote!(principal(0.999e-9, 1, 1))).len(), 0);
}

/// Of an inertia that is not constant, or of a motion about one direction, nothing is said.
#[test]
fn elsewhere_nothing_is_said() {
    let planar = quote!(Body {
        motion: planar,
        mass: 3,
        inertia: 2
    });
    let hinged = quote!(Body {
        motion: fixed_axis(G, body(0, 0, 1)),
        inertia: principal(1, 2, 2)
    });
    let param = quote!(Body {
        motion: rotation,
        params: [a = 1],
        inertia: principal(a, 2, 2)
    });
    for description in [planar, hinged, param] {
        assert_eq!(of("Inertia about G:", description), [""; 0]);
    }
}

#[test]
fn where_a_field_acts_on_charges() {
    let lines = of(
        "Charges:",
        quote!(Needle {
            motion: spatial,
            params: [e = 1[C]],
            mass: 1[kg],
            inertia: principal(1, 2, 2)[kg * m ^ 2],
            points: [a = (1, 0, 0)[m], b = (-0.5, 0.25, 0)[m]],
            fields: [
                pull = world(0, 0, 2)[V / m].on([3[C].at(a), 1[C].at(b)]),
                turn = world(0, 0, 1)[V / m].on([1[C].at(a), -1[C].at(b)]),
                open = world(0, 0, 1)[V / m].on([e.at(a), 1[C].at(b)]),
            ],
        }),
    );
    assert_eq!(
        lines,
        [
            "`pull`: acts at r_0 = (0.625, 0.0625, 0) m from G, in body axes",
            "`turn`: net charge zero: a couple p x E, p = (1.5, -0.25, 0) in body axes"
        ]
    );
    let planar = of(
        "Charges:",
        quote!(Plate {
            motion: planar,
            mass: 1[kg],
            inertia: 1[kg * m ^ 2],
            points: [a = (1, 0)[m]],
            fields: [pull = world(0, 1)[V / m].on([3[C].at(a)])],
        }),
    );
    assert_eq!(
        planar,
        ["`pull`: acts at r_0 = (1, 0) m from G, in body axes"]
    );
}

/// The lines under "Closed form:".
fn closed_form(description: TokenStream) -> Vec<String> {
    of("Closed form:", description)
}

#[test]
fn closed_forms() {
    let turning = |inertia: TokenStream| {
        closed_form(
            quote!(Body { motion: rotation, params: [j = 2], inertia: #inertia, outputs: [flow] }),
        )
    };
    assert_eq!(
        turning(quote!(principal(1, 1, 1))),
        ["the body turns at a constant rate"]
    );
    assert_eq!(
        turning(quote!(principal(1, 2, 1))),
        ["the body precesses steadily"]
    );
    assert_eq!(
        turning(quote!(principal(1, 2, 3))),
        ["the body turns by elliptic functions"]
    );
    assert_eq!(
        turning(quote!(principal(1, j, 3))),
        ["the body turns freely, in a way that its moments of inertia decide"]
    );
    assert_eq!(
        closed_form(quote!(Body {
            motion: pivot(P),
            mass: 1,
            inertia: 1,
            points: [P = (0, 1)],
            fields: [weight = mass * world(0, -9.81)],
            outputs: [flow]
        })),
        ["the angle is that of a pendulum, by elliptic functions"]
    );
    assert_eq!(
        closed_form(quote!(Body {
            motion: rod(body(1, 0, 0)),
            mass: 1,
            inertia: 1,
            outputs: [flow]
        })),
        [
            "G moves on a parabola",
            "the axis turns along a great circle"
        ]
    );
}

#[test]
fn closed_forms_of_systems() {
    let satellite = quote!((::newton_euler) Satellite {
        bodies: [
            hub { mass: 50, inertia: principal(2, 2, 1) },
            wheel { mass: 3, inertia: principal(0.4, 0.4, 0.6) },
            bob { mass: 3, inertia: principal(0.4, 0.4, 0.6), points: [pin = (0, 1, 0)] },
        ],
        joints: [
            orbit = free(hub),
            spin = revolute(hub.G, wheel.G, body(0, 0, 1)),
            swing = revolute(world(0, 0, 0), bob.pin, world(1, 0, 0)),
        ],
        fields: [weight = mass * world(0, 0, -9.81)],
        outputs: [flow],
    });
    let text = expand_system(satellite).to_string();
    for line in [
        "`orbit`: the center of mass moves on a parabola, the body precesses steadily, as a gyrostat",
        "`spin`: at constant acceleration",
        "`swing`: the angle is that of a pendulum, by elliptic functions",
    ] {
        assert!(text.contains(line), "{line}");
    }
}

/// The documentation of the fields of parameters, inputs, the state and the acceleration.
fn of_fields(description: TokenStream) -> Vec<String> {
    let text = expand_description(description).to_string();
    let docs = text.split("doc = \" ").skip(1);
    let docs = docs.filter_map(|rest| rest.split("\"]").next());
    docs.map(str::to_owned).collect()
}

/// Units are those that were written, a rate's are theirs by the second; what has none is in SI.
#[test]
fn units_of_fields() {
    let fields = of_fields(quote!(Body {
        motion: translation,
        mass: 3[kg] + fuel,
        inertia: principal(1, 2, 2.5)[kg * m ^ 2],
        params: [
            flow = 1.5[kg / s],
            damper = -2[N * s / m],
            heat = 300[g / s],
            conductance = 6[W / K],
            reach = world(1, 0, 0)[m],
        ],
        inputs: [turn[rad].moving, wind = world(_, _, _)[J / (N * s)]],
        states: [fuel[kg], thrust[N], work[J], speed[m / s], share],
        rates: [
            fuel = -flow - 0 * heat,
            thrust = 2[N / s] * turn * conductance * 1[K / W],
            work = 0[W],
            speed = 0[m / s ^ 2],
            share = 0,
        ],
        forces: [push = world(thrust, 0, 0) + damper * wind + reach * 1[N / m] * turn_rate * 1[s]],
    }));
    for line in [
        "`flow` in kg / s, 1.5 by default.",
        "`damper` in N * s / m, -2 by default.",
        "`heat` in kg / s, 0.3 by default.",
        "`conductance` in W / K, 6 by default.",
        "`reach` in m, world axes, (1, 0, 0) by default.",
        "`turn_rate` in rad / s.",
        "`turn_acceleration` in rad / s ^ 2.",
        "`wind` in J / (N * s), world axes.",
        "The rate of `fuel` in kg / s.",
        "The rate of `thrust` in N / s.",
        "The rate of `work` in J / s.",
        "The rate of `speed` in m / s ^ 2.",
        "The rate of `share` without a unit.",
    ] {
        assert!(
            fields.iter().any(|field| field == line),
            "{line}: {fields:?}"
        );
    }
}

/// Parameters stand in the documentation of the body and of `new`, with their defaults.
#[test]
fn parameters() {
    let description = quote!(Body {
        motion: translation,
        params: [
            #[doc = " The mass of the hull,"]
            #[doc = " without fuel."]
            #[doc = ""]
            #[doc = " As weighed."]
            hull = 2[t],
            wind = world(1e-9, 0, -0.5)[m / s],
            share = 0.25,
            drag[N * s / m],
        ],
        mass: hull * share,
        forces: [drag = drag * (wind - velocity)],
    });
    let rows = [
        "`hull` = 2000 kg: The mass of the hull, without fuel.",
        "`wind` = (1e-9, 0, -0.5) m / s, world axes",
        "`share` = 0.25",
        "`drag` in N * s / m",
    ];
    let of_body = expand_description(description.clone()).to_string();
    let list = format!(r#"\n Parameters:\n - {}""#, rows.join(r"\n - "));
    assert!(of_body.contains(&list), "{of_body}");

    let of_new = pretty(description);
    let of_new = of_new
        .split_once("/// Checks the parameters")
        .expect("`new` is there");
    let lines = of_new.1.lines().skip(1);
    let of_new: Vec<&str> = lines
        .map_while(|line| line.trim_start().strip_prefix("/// - "))
        .collect();
    assert_eq!(of_new, rows);
}

/// A changing mass may vanish, and nothing is said of constraints where there are none.
#[test]
fn singular_configurations() {
    let rocket = quote!(Body {
        motion: translation,
        mass: 1[kg] + fuel,
        states: [fuel[kg]],
        rates: [fuel = -1[kg / s]],
        forces: [push = world(1[N], 0, 0)],
    });
    let bead = quote!(Body {
        motion: translation,
        mass: 1,
        constraints: [wire = position.norm_squared() - 1[m ^ 2]],
        reactions: [tension = _ * (position / 1[m])],
    });
    for (description, mass, constraints) in [(rocket, true, false), (bead, false, true)] {
        let expansion = pretty(description);
        assert!(expansion.contains("# Singular configurations"));
        assert_eq!(expansion.contains("Where the mass or an inertia"), mass);
        assert_eq!(
            expansion.contains("Where the constraints do not"),
            constraints
        );
    }
}

/// The lines of text in editors that state laws.
fn laws(expansion: TokenStream) -> Vec<String> {
    let text = expansion.to_string();
    let (_, rest) = text
        .split_once("(not (doc) , doc = \"")
        .expect("a text for editors");
    let (lines, _) = rest.split_once('"').expect("its end");
    let lines = lines.split("\\n - `").skip(1);
    lines
        .map(|law| law.trim_end_matches('`').to_owned())
        .collect()
}

#[test]
fn laws_name_their_loads() {
    let drone = expand_description(quote!(Drone {
        motion: spatial,
        inputs: [thrust[N], twist[N * m]],
        mass: 1.25[kg],
        inertia: principal(0.0123, 0.0123, 0.067 / 3)[kg * m ^ 2],
        points: [front = (0.2, 0, 0)],
        fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
        forces: [
            lift = body(0, 0, thrust).at(front),
            push = body(thrust, 0, 0)
        ],
        moments: [drag = body(0, 0, twist)],
    }));
    assert_eq!(
        laws(drone),
        [
            "m a = F_weight + F_lift + F_push, m = 1.25 kg",
            "J ω′ + ω × J ω = r × F_lift + M_drag, J = diag(0.0123, 0.0123, 0.022333) kg m²",
        ]
    );
    let pendulum = expand_description(quote!(Pendulum {
        motion: pivot(hinge),
        mass: 2[kg],
        inertia: 0.5[kg * m ^ 2],
        points: [hinge = (0, 0.5)],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    }));
    // about the hinge: 0.5 + 2 / 4
    assert_eq!(laws(pendulum), ["J φ″ = r × F_weight, J = 1 kg m²"]);
    let free = expand_description(quote!(Rock {
        motion: rotation,
        mass: 1,
        inertia: tensor {
            xx: 2,
            yy: 3,
            zz: 4,
            xy: 0.5
        },
    }));
    assert_eq!(
        laws(free),
        ["J ω′ + ω × J ω = 0, J = [2, 0.5, 0; 0.5, 3, 0; 0, 0, 4] kg m²"]
    );
}

#[test]
fn joints_act_on_both_of_their_bodies() {
    let arm = expand_system(quote!((::newton_euler) Arm {
        motion: planar,
        bodies: [
            upper { mass: 2[kg], inertia: 1[kg * m ^ 2], points: [a = (1, 0), b = (-1, 0)] },
            lower { mass: 3[kg], inertia: 1[kg * m ^ 2], points: [a = (1, 0)] },
        ],
        joints: [shoulder = revolute(world(0, 0), upper.a), elbow = revolute(upper.b, lower.a)],
    }));
    assert_eq!(
        laws(arm),
        [
            "upper: m a = F_shoulder − F_elbow, m = 2 kg",
            "upper: J φ″ = r × F_shoulder + M_shoulder − r × F_elbow − M_elbow, J = 1 kg m²",
            "lower: m a = F_elbow, m = 3 kg",
            "lower: J φ″ = r × F_elbow + M_elbow, J = 1 kg m²",
        ]
    );
}

#[test]
fn pages_have_few_digits_and_no_guards() {
    let ladder = expand_description(quote!(Ladder {
        motion: planar,
        mass: 3[kg],
        inertia: 1[kg * m ^ 2],
        points: [foot = (-1.5, 0), top = (1.5, 0)],
        inputs: [
            #[doc = " Of a hand."]
            push[N]
        ],
        forces: [hand = world(push, 0)],
        constraints: [
            floor = foot.position().in_world().y,
            wall = top.position().in_world().x
        ],
        reactions: [ground = world(0, _).at(foot), side = world(_, 0).at(top)],
    }));
    let text = ladder.to_string();
    assert!(
        text.contains("<span title=\\\"0.3333333333333333\\\">0.33333</span>"),
        "{text}"
    );
    assert!(
        text.contains("\" Of a hand.\\n\\n `push` in N.\""),
        "{text}"
    );
    let listing = text.split("const TEXT").nth(1).expect("the equations");
    let listing = listing.split("TEXT }").next().expect("their end");
    assert!(listing.contains(" = 1 / "), "{listing}");
    assert!(
        !listing.contains("determined") && !listing.contains("private"),
        "{listing}"
    );
}
