use newton_euler::rigid_body;

rigid_body!(Stone::<f32> {
    motion: translation,
    mass: 1[kg],
});

fn main() {
    let _ = Stone::<f32>::default();
}
