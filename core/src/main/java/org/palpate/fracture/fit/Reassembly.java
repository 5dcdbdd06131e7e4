package org.palpate.fracture.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.palpate.geometry.Pose;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Proposes a pose for each fragment of a bone. Fragments that cannot move are in place. Each call
 * of {@link #add} adds the fragment that fits best to one in place, at the pose that {@link
 * GlobalFit} finds. Nothing is moved, and fragments may overlap at the proposed poses. One thread
 * an instance, never the haptic one.
 */
public final class Reassembly {
  private final GlobalFit fits;
  private final List<Pose> present;
  private final List<Pose> proposed = new ArrayList<>();
  private final boolean[] inPlace;

  /** The proposal for each pair of fragments, made when it is needed first; null before. */
  private final List<List<Optional<GlobalFit.Proposal>>> found = new ArrayList<>();

  /**
   * A fragment that is added to one in place.
   *
   * @param fragment the index of the fragment
   * @param other the index of the fragment that it fits to
   * @param scoreMm2 the area that speaks for the pose less the area against it, mm^2
   * @param nextScoreMm2 the score of the next best pose of the two, mm^2; 0 without one
   */
  public record Joint(int fragment, int other, double scoreMm2, double nextScoreMm2) {}

  /**
   * Prepares proposals.
   *
   * @param grids the grid of each fragment
   * @param fragments the voxels of each fragment at rest
   * @param gapMm the width of the gap between faces that fit, mm
   * @param present the pose of each fragment, from rest to present, world mm
   * @param isFixed which fragments cannot move; if none, the first stays
   */
  public Reassembly(
      List<VoxelGrid> grids,
      List<BitCube> fragments,
      double gapMm,
      List<Pose> present,
      IntPredicate isFixed) {
    fits = new GlobalFit(grids, fragments, gapMm);
    this.present = List.copyOf(present);
    inPlace = new boolean[fragments.size()];
    boolean any = false;
    for (int n = 0; n < inPlace.length; n++) {
      inPlace[n] = isFixed.test(n);
      any |= inPlace[n];
      proposed.add(new Pose().set(present.get(n)));
      List<Optional<GlobalFit.Proposal>> row = new ArrayList<>();
      for (int m = 0; m < inPlace.length; m++) {
        row.add(null);
      }
      found.add(row);
    }
    if (!any && inPlace.length > 0) {
      inPlace[0] = true;
    }
  }

  /**
   * {@return the pose that is proposed for each fragment; the present one of a fragment that was
   * not added}
   */
  public List<Pose> poses() {
    return List.copyOf(proposed);
  }

  /**
   * Adds the fragment that fits best. Takes up to a few seconds for each pair that is compared for
   * the first time.
   *
   * @return the fragment that was added; empty if no other one fits to one in place
   */
  public Optional<Joint> add() {
    Joint best = null;
    for (int n = 0; n < inPlace.length; n++) {
      for (int m = 0; m < inPlace.length && !inPlace[n]; m++) {
        Optional<GlobalFit.Proposal> fit = inPlace[m] ? fit(n, m) : Optional.empty();
        if (fit.isPresent() && (best == null || fit.get().scoreMm2() > best.scoreMm2)) {
          best = new Joint(n, m, fit.get().scoreMm2(), fit.get().nextScoreMm2());
        }
      }
    }
    if (best != null) {
      place(best.fragment, best.other);
    }
    return Optional.ofNullable(best);
  }

  /**
   * {@return the indices of the fragments that were not added: none of the poses that were tried
   * speaks for them next to one in place}
   */
  public List<Integer> left() {
    return IntStream.range(0, inPlace.length).filter(n -> !inPlace[n]).boxed().toList();
  }

  private Optional<GlobalFit.Proposal> fit(int fragment, int other) {
    List<Optional<GlobalFit.Proposal>> row = found.get(fragment);
    if (row.get(other) == null) {
      row.set(other, fits.propose(fragment, other, present));
    }
    return row.get(other);
  }

  /** Gives a fragment the pose that it was proposed relative to another. */
  private void place(int fragment, int other) {
    Pose fitted = fit(fragment, other).orElseThrow().pose();
    Pose relative = present.get(other).inverseMultiply(fitted, new Pose());
    proposed.get(other).multiply(relative, proposed.get(fragment));
    proposed.get(fragment).rotation.normalize();
    inPlace[fragment] = true;
  }
}
