//! The places of the blocks of a linearization in its matrices.

use std::collections::HashSet;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use crate::emit::code::{Shapes, Site, Values, local};
use crate::mechanics::{Block, Column, Row};
use crate::model::{AXES, Declared, Group, Outline, Variable};

/// The most blocks that an invalid description gets.
const MOST_BLOCKS: usize = 4096;

/// The tangent space of the states and the inputs, in groups of components.
pub struct Space {
    state: Vec<Group>,
    accelerations: Vec<Group>,
    inputs: Vec<(String, usize)>,
    params: Vec<(String, usize)>,
}

/// A block, and its place in the matrices.
pub struct Placed {
    pub name: Ident,
    size: [usize; 2],
    /// Its first row and first column.
    at: [usize; 2],
    is_of_input: bool,
}

impl Space {
    pub fn of(outline: &Outline) -> Self {
        let sized = |declared: &[Declared]| {
            let sized = declared.iter().map(|one| {
                let size = one.frame.map_or(1, |_| outline.motion.axes());
                (one.name.to_string(), size)
            });
            sized.collect()
        };
        Self {
            state: outline.tangent(),
            accelerations: outline.accelerations(),
            inputs: sized(&outline.inputs),
            params: sized(&outline.params),
        }
    }

    /// The number of coordinates; the rates come after them.
    fn places(&self) -> usize {
        self.size()[0] - components(&self.accelerations)
    }

    /// The number of coordinates and rates, and of components of inputs.
    fn size(&self) -> [usize; 2] {
        [
            components(&self.state),
            self.inputs.iter().map(|(_, size)| size).sum(),
        ]
    }

    pub fn placed(&self, block: &Block) -> Placed {
        self.place(block.row, block.column)
    }

    fn place(&self, row: Row, column: Column) -> Placed {
        let (changing, first) = match row {
            Row::Attitude(number) => (&self.state[number], components(&self.state[..number])),
            Row::Acceleration(number) => {
                let first = components(&self.accelerations[..number]);
                (&self.accelerations[number], self.places() + first)
            }
        };
        let (name, columns, at) = match column {
            Column::State(number) => {
                let group = &self.state[number];
                (&group.name, group.size, components(&self.state[..number]))
            }
            Column::Input(number) => {
                let (name, size) = &self.inputs[number];
                let at = self.inputs[..number].iter().map(|(_, size)| size).sum();
                (name, *size, at)
            }
            Column::Param(number) => {
                let (name, size) = &self.params[number];
                let at = self.params[..number].iter().map(|(_, size)| size).sum();
                (name, *size, at)
            }
        };
        Placed {
            name: format_ident!("{}_by_{}", changing.name, name.trim_start_matches("r#")),
            size: [changing.size, columns],
            at: [first, at],
            is_of_input: matches!(column, Column::Input(_)),
        }
    }

    /// All possible blocks, unless there are too many.
    pub fn all(&self) -> Vec<Placed> {
        if self.accelerations.len() * (self.state.len() + self.inputs.len()) > MOST_BLOCKS {
            return Vec::new();
        }
        let attitudes = self.state.iter().enumerate();
        let attitudes = attitudes.filter(|(_, group)| group.variable == Variable::Quaternion);
        let attitudes =
            attitudes.map(|(number, _)| self.place(Row::Attitude(number), Column::State(number)));
        let rows = 0..self.accelerations.len();
        let blocks = rows.flat_map(|row| {
            let state = (0..self.state.len()).map(Column::State);
            let columns = state.chain((0..self.inputs.len()).map(Column::Input));
            columns.map(move |column| self.place(Row::Acceleration(row), column))
        });
        // an input with the name of a coordinate is reported elsewhere
        let mut seen = HashSet::new();
        let all = attitudes.chain(blocks);
        all.filter(|one| seen.insert(one.name.clone())).collect()
    }

    /// All possible blocks of derivatives with respect to parameters.
    pub fn by_params(&self) -> Vec<Placed> {
        let rows = 0..self.accelerations.len();
        let columns = |row| (0..self.params.len()).map(move |number| (row, number));
        let blocks = rows.flat_map(columns);
        let placed =
            blocks.map(|(row, number)| self.place(Row::Acceleration(row), Column::Param(number)));
        placed.collect()
    }

    /// The names of the coordinates and of the components of inputs.
    fn names(&self) -> [Vec<String>; 2] {
        [of_groups(&self.state), of_declared(&self.inputs)]
    }

    /// The entries of A and B that may be nonzero.
    pub fn patterns(&self, blocks: &[Block]) -> [Vec<Vec<bool>>; 2] {
        let [states, inputs] = self.size();
        let mut patterns = [
            vec![vec![false; states]; states],
            vec![vec![false; inputs]; states],
        ];
        for row in 0..self.places() {
            patterns[0][row][row + self.places()] = true;
        }
        for block in blocks {
            let placed = self.placed(block);
            let pattern = &mut patterns[usize::from(placed.is_of_input)];
            let [rows, _] = placed.size;
            for (number, is_there) in block.is_there.iter().enumerate() {
                let [row, column] = [number % rows, number / rows];
                pattern[placed.at[0] + row][placed.at[1] + column] |= is_there;
            }
        }
        patterns
    }

    /// `impl Linearized<STATES, INPUTS> for BodyLinearization`; for an invalid description, without
    /// a pattern.
    pub fn matrices(
        &self,
        site: &Site<'_>,
        blocks: &[Placed],
        patterns: Option<&[Vec<Vec<bool>>; 2]>,
    ) -> TokenStream {
        let private = &site.shapes.private;
        let kind = site.own_type("Linearization");
        let [states, inputs] = self.size().map(Literal::usize_unsuffixed);
        let [coordinates, components] = self.names();
        let of = |number: usize, columns: &Literal| {
            let Some(patterns) = patterns else {
                return quote!([[true; #columns]; #states]);
            };
            let rows = patterns[number].iter().map(|row| quote!([#(#row),*]));
            quote!([#(#rows),*])
        };
        let (of_state, of_input) = (of(0, &states), of(1, &inputs));
        let (matrix, places) = (local("matrix"), Literal::usize_unsuffixed(self.places()));
        let filled = |is_of_input: bool| {
            let blocks = blocks.iter().filter(|one| one.is_of_input == is_of_input);
            let placed = blocks.map(|one| one.put(site, 0));
            quote!(#(#placed)*)
        };
        let (a, b) = (filled(false), filled(true));
        let mutable = (!b.is_empty()).then(|| quote!(mut));
        quote! {
            impl #private::Linearized<#states, #inputs> for #kind {
                const STATES: [&'static str; #states] = [#(#coordinates),*];
                const INPUTS: [&'static str; #inputs] = [#(#components),*];
                const A_PATTERN: [[bool; #states]; #states] = #of_state;
                const B_PATTERN: [[bool; #inputs]; #states] = #of_input;

                fn a(&self) -> #private::SMatrix<f64, #states, #states> {
                    let mut #matrix = #private::rates_of_places(#places);
                    #a
                    #matrix
                }

                fn b(&self) -> #private::SMatrix<f64, #states, #inputs> {
                    let #mutable #matrix = #private::SMatrix::zeros();
                    #b
                    #matrix
                }
            }
        }
    }
}

impl Space {
    /// `impl ByParams<RATES, PARAMS> for BodySensitivity`.
    pub fn by_params_matrix(&self, site: &Site<'_>, blocks: &[Placed]) -> TokenStream {
        let private = &site.shapes.private;
        let kind = site.own_type("Sensitivity");
        let [rates, params] = [of_groups(&self.accelerations), of_declared(&self.params)];
        let [rows, columns] = [&rates, &params].map(|names| Literal::usize_unsuffixed(names.len()));
        let matrix = local("matrix");
        let placed: Vec<TokenStream> = blocks
            .iter()
            .map(|one| one.put(site, self.places()))
            .collect();
        let mutable = (!placed.is_empty()).then(|| quote!(mut));
        quote! {
            impl #private::ByParams<#rows, #columns> for #kind {
                const RATES: [&'static str; #rows] = [#(#rates),*];
                const PARAMS: [&'static str; #columns] = [#(#params),*];

                fn by_params(&self) -> #private::SMatrix<f64, #rows, #columns> {
                    let #mutable #matrix = #private::SMatrix::zeros();
                    #(#placed)*
                    #matrix
                }
            }
        }
    }
}

/// The names of the components of groups.
fn of_groups(groups: &[Group]) -> Vec<String> {
    let groups = groups.iter();
    groups
        .flat_map(|group| spread(&group.name, group.size))
        .collect()
}

/// The names of the components of inputs or parameters.
fn of_declared(declared: &[(String, usize)]) -> Vec<String> {
    let declared = declared.iter();
    declared
        .flat_map(|(name, size)| spread(name, *size))
        .collect()
}

fn spread(name: &str, size: usize) -> impl Iterator<Item = String> {
    let name = name.trim_start_matches("r#").to_owned();
    (0..size).map(move |part| match size {
        1 => name.clone(),
        _ => format!("{name}_{}", AXES[part]),
    })
}

/// The number of components of all groups.
fn components(groups: &[Group]) -> usize {
    groups.iter().map(|group| group.size).sum()
}

impl Placed {
    /// Puts the block of `self` into a matrix; `first` is the first row of that matrix.
    fn put(&self, site: &Site<'_>, first: usize) -> TokenStream {
        let (private, name, matrix) = (&site.shapes.private, &self.name, local("matrix"));
        let [row, column] = [self.at[0] - first, self.at[1]].map(Literal::usize_unsuffixed);
        if self.size == [1, 1] {
            quote!(#matrix[(#row, #column)] = self.#name;)
        } else {
            quote!(#private::place(&mut #matrix, [#row, #column], &self.#name);)
        }
    }

    pub fn kind(&self, shapes: &Shapes) -> TokenStream {
        match self.size {
            [1, 1] => shapes.scalar.kind(),
            size => shapes.matrix_type(size),
        }
    }

    pub fn filled(&self, shapes: &Shapes, values: &mut Values<'_>) -> TokenStream {
        match self.size {
            [1, 1] => {
                let value = values.next();
                quote!(#value)
            }
            size => shapes.matrix(size, values),
        }
    }
}
