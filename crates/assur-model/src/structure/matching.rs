//! Maximum matching of scalar conditions to the freedoms of bodies.

/// A scalar condition (or, on the side of forces, a scalar unknown) and the freedoms it can take.
#[derive(Clone, Debug)]
pub struct Condition {
    pub nodes: Vec<usize>,
}

/// A matching of conditions to nodes of limited capacity.
pub struct Matching {
    /// The node each condition is matched to.
    pub node_of: Vec<Option<usize>>,
    /// The conditions matched to each node.
    pub held: Vec<Vec<usize>>,
}

/// Matches as many conditions as possible, earlier ones first. `capacity` is the number of freedoms of each node.
pub fn match_all(conditions: &[Condition], capacity: &[usize]) -> Matching {
    let mut m = Matching { node_of: vec![None; conditions.len()], held: vec![Vec::new(); capacity.len()] };
    let mut found_by = vec![usize::MAX; capacity.len()];
    let mut touched = Vec::new();
    for start in 0..conditions.len() {
        m.augment(start, conditions, capacity, &mut found_by, &mut touched);
        for &node in &touched {
            found_by[node] = usize::MAX;
        }
        touched.clear();
    }
    m
}

impl Matching {
    fn augment(
        &mut self,
        start: usize,
        conditions: &[Condition],
        capacity: &[usize],
        found_by: &mut [usize],
        touched: &mut Vec<usize>,
    ) {
        let mut queue = std::collections::VecDeque::from([start]);
        while let Some(condition) = queue.pop_front() {
            for &node in &conditions[condition].nodes {
                if found_by[node] != usize::MAX {
                    continue;
                }
                found_by[node] = condition;
                touched.push(node);
                if self.held[node].len() < capacity[node] {
                    self.shift(node, found_by);
                    return;
                }
                queue.extend(self.held[node].iter().copied());
            }
        }
    }

    /// Walks back from a free node and moves every condition on the way one node on.
    fn shift(&mut self, free: usize, found_by: &[usize]) {
        let mut node = free;
        loop {
            let condition = found_by[node];
            let left = self.node_of[condition].replace(node);
            self.held[node].push(condition);
            let Some(left) = left else { return };
            self.held[left].retain(|&c| c != condition);
            node = left;
        }
    }

    /// Whether every condition has a node and no node has room left.
    pub fn is_complete(&self, capacity: &[usize]) -> bool {
        self.node_of.iter().all(Option::is_some) && self.held.iter().zip(capacity).all(|(h, c)| h.len() == *c)
    }
}

/// Strongly connected components of a directed graph, each after those it points to (Tarjan, without recursion).
pub fn components(successors: &[Vec<usize>]) -> Vec<Vec<usize>> {
    const NEW: usize = usize::MAX;
    let n = successors.len();
    let (mut index, mut low) = (vec![NEW; n], vec![0; n]);
    let mut on_stack = vec![false; n];
    let (mut stack, mut out, mut next) = (Vec::new(), Vec::new(), 0);
    for root in 0..n {
        if index[root] != NEW {
            continue;
        }
        let mut work = vec![(root, 0)];
        while let Some(&(v, edge)) = work.last() {
            if edge == 0 {
                index[v] = next;
                low[v] = next;
                next += 1;
                stack.push(v);
                on_stack[v] = true;
            }
            if let Some(&w) = successors[v].get(edge) {
                if let Some(top) = work.last_mut() {
                    top.1 += 1;
                }
                if index[w] == NEW {
                    work.push((w, 0));
                } else if on_stack[w] {
                    low[v] = low[v].min(index[w]);
                }
                continue;
            }
            work.pop();
            if let Some(&(parent, _)) = work.last() {
                low[parent] = low[parent].min(low[v]);
            }
            if low[v] == index[v] {
                let mut component = Vec::new();
                while let Some(w) = stack.pop() {
                    on_stack[w] = false;
                    component.push(w);
                    if w == v {
                        break;
                    }
                }
                component.sort_unstable();
                out.push(component);
            }
        }
    }
    out
}
