//! A function that can panic: this program must not link.

#[macro_use]
mod guard;

cannot_panic! {
    fn broken(list: &[f64], place: usize) -> f64 {
        list[place]
    }
}

fn main() {
    println!("{} function", link());
}
