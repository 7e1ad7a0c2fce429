//! Connected parts of the boxes that are proved inside: boxes are connected if they share a face, or a part of one.

use super::tree::{Kind, Tree};

/// For each box of the tree that is inside, the number of its part; parts are numbered from the largest on.
pub struct Parts {
    of: Vec<u32>,
    /// Number of parts.
    pub count: usize,
}

impl Parts {
    /// The parts of a tree.
    pub fn of(tree: &Tree) -> Self {
        let mut leader: Vec<u32> = (0..tree.len() as u32).collect();
        let is_inside = |node: u32| tree.kind(node) == Kind::Inside;
        for leaf in tree.leaves().filter(|leaf| is_inside(*leaf)) {
            // Of two boxes that share a face, the smaller one finds the larger.
            for face in 0..6 {
                let beyond = tree.beyond(leaf, face / 2, face % 2 == 1).filter(|other| is_inside(*other));
                if let Some(other) = beyond {
                    let [a, b] = [leaf, other].map(|node| first(&mut leader, node));
                    leader[a.max(b) as usize] = a.min(b);
                }
            }
        }
        let mut volume = vec![0.0; tree.len()];
        for leaf in tree.leaves().filter(|leaf| is_inside(*leaf)) {
            volume[first(&mut leader, leaf) as usize] += tree.volume(leaf);
        }
        let mut leaders: Vec<u32> =
            tree.leaves().filter(|leaf| is_inside(*leaf) && leader[*leaf as usize] == *leaf).collect();
        leaders.sort_by(|a, b| volume[*b as usize].total_cmp(&volume[*a as usize]).then(a.cmp(b)));
        let mut number = vec![u32::MAX; tree.len()];
        (0..).zip(&leaders).for_each(|(part, node)| number[*node as usize] = part);
        let of = (0..tree.len() as u32).map(|node| number[first(&mut leader, node) as usize]).collect();
        Parts { of, count: leaders.len() }
    }

    /// The part of a box that is inside.
    pub fn number(&self, node: u32) -> u32 {
        self.of[node as usize]
    }
}

/// The first box of those that are known to be connected with a box.
fn first(leader: &mut [u32], mut node: u32) -> u32 {
    while leader[node as usize] != node {
        let next = leader[leader[node as usize] as usize];
        leader[node as usize] = next;
        node = next;
    }
    node
}
