//! Who solves which case: a worker stays with the bodies that it has condensed as long as they have cases, then begins a group that
//! no worker has begun, and helps another worker only when there is none.

use std::collections::VecDeque;

/// Cases by the bodies that they share.
#[derive(Debug)]
pub(super) struct Queue {
    groups: Vec<(VecDeque<usize>, bool)>,
}

impl Queue {
    pub(super) fn new(groups: impl IntoIterator<Item = Vec<usize>>) -> Self {
        let group = |cases: Vec<usize>| (cases.into(), false);
        Self {
            groups: groups.into_iter().map(group).collect(),
        }
    }

    /// The next case for a worker that has just solved one of group `own`: the group and the case.
    pub(super) fn next(&mut self, own: Option<usize>) -> Option<(usize, usize)> {
        let waiting = |(cases, _): &(VecDeque<usize>, bool)| !cases.is_empty();
        let stay = own.filter(|&group| self.groups.get(group).is_some_and(waiting));
        let begin = || {
            self.groups
                .iter()
                .position(|group| waiting(group) && !group.1)
        };
        let help = || {
            let groups = self.groups.iter().enumerate();
            let fullest = groups.max_by_key(|(_, (cases, _))| cases.len());
            fullest.map(|(index, _)| index)
        };
        let group = stay.or_else(begin).or_else(help)?;
        let (cases, begun) = self.groups.get_mut(group)?;
        *begun = true;
        cases.pop_front().map(|case| (group, case))
    }
}

#[cfg(test)]
mod tests {
    use super::Queue;

    #[test]
    fn workers_stay_begin_and_help() {
        let mut queue = Queue::new([vec![0, 1, 2, 3], vec![4, 5]]);
        assert_eq!(queue.next(None), Some((0, 0)));
        assert_eq!(queue.next(None), Some((1, 4)));
        assert_eq!(queue.next(Some(1)), Some((1, 5)));
        assert_eq!(queue.next(Some(1)), Some((0, 1)));
        assert_eq!(queue.next(Some(0)), Some((0, 2)));
        assert_eq!(queue.next(Some(0)), Some((0, 3)));
        assert_eq!(queue.next(Some(0)), None);
    }
}
