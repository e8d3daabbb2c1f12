use newton_euler::rigid_body;

rigid_body!(Bead {
    motion: planar_translation,
    mass: 1[kg],
    locals: [p = position.in_world()],
    constraints: [floor = p.y, wall = p.x],
    reactions: [push = _ * floor.gradient(), lean = _ * floor.gradient()],
});

fn main() {}
