//! Descriptions of the files in this folder.

use newton_euler::prelude::*;

rigid_system!(Arm {
    mjcf: "tests/mjcf/arm.xml",
    outputs: [energy],
});

rigid_system!(Quadruped {
    mjcf: "tests/mjcf/quadruped.xml"
});

rigid_system!(Swing {
    mjcf: "tests/mjcf/swing.xml",
    locked: [held = 50[mm]],
});

rigid_system!(Linkage {
    mjcf: "tests/mjcf/linkage.xml"
});

rigid_system!(Coupled {
    mjcf: "tests/mjcf/coupled.xml"
});

rigid_system!(Classes {
    mjcf: "tests/mjcf/classes.xml"
});
