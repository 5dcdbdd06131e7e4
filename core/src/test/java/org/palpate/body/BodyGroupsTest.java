package org.palpate.body;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.testing.Seeds;

/** Compares groups with sets of bodies. */
class BodyGroupsTest {
  private static final int BODIES = 7;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final List<Set<Integer>> sets = new ArrayList<>();
  private final boolean[] locked = new boolean[BODIES];
  private BodyGroups groups = BodyGroups.none(BODIES);

  private Set<Integer> setOf(int body) {
    return sets.stream().filter(set -> set.contains(body)).findFirst().orElseThrow();
  }

  @Test
  void anyOrderOfChangesGivesWhatSetsGive() {
    for (int n = 0; n < BODIES; n++) {
      sets.add(new HashSet<>(Set.of(n)));
    }
    for (int n = 0; n < 2000; n++) {
      change(random.nextInt(BODIES), random.nextInt(BODIES));
      compare();
    }
  }

  private void change(int a, int b) {
    switch (random.nextInt(4)) {
      case 0 -> {
        groups = groups.bound(a, b);
        Set<Integer> other = setOf(b);
        if (!setOf(a).contains(b)) {
          sets.remove(other);
          setOf(a).addAll(other);
        }
      }
      case 1, 2 -> {
        groups = groups.alone(a);
        if (setOf(a).size() > 1) {
          setOf(a).remove(a);
          sets.add(new HashSet<>(Set.of(a)));
        }
      }
      default -> {
        boolean isLocked = random.nextBoolean();
        groups = groups.withLock(a, isLocked);
        setOf(a).forEach(body -> locked[body] = isLocked);
      }
    }
  }

  private void compare() {
    for (int a = 0; a < BODIES; a++) {
      assertEquals(setOf(a).size(), groups.size(a));
      assertEquals(setOf(a).stream().anyMatch(body -> locked[body]), groups.isLocked(a));
      for (int b = 0; b < BODIES; b++) {
        assertEquals(setOf(a).contains(b), groups.moveTogether(a, b), "seed " + Seeds.seed());
      }
    }
  }
}
