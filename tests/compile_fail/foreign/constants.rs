use newton_euler::rigid_body;

rigid_body!(Wing {
    motion: translation,
    mass: 12[kg],
    constants: [
        area[m ^ 2] = crate::AREA,
        span = 12[m],
        bare,
        none = [m],
        odd = crate::AREA[m ^ 2] + 1,
        unit = crate::AREA[furlong],
        area_2 = crate::AREA[m ^ 2],
        area_2 = crate::AREA[m ^ 2],
        t = crate::AREA,
        chord = crate::AREA[m],
        let = crate::AREA,
    ],
    params: [chord],
    forces: [pull = (area + span + bare + none + odd + unit + area_2) * world(1, 0, 0)],
});

fn main() {}
