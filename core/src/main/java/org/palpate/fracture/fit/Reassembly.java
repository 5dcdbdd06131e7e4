package org.palpate.fracture.fit;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.palpate.geometry.Pose;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Proposes a pose for each fragment of a bone. Fragments that cannot move are in place. {@link
 * GlobalFit} finds poses beside each fragment in place. Each call of {@link #add} adds the fragment
 * whose pose has the best score in view of all that are in place, and {@link FaceFit} lays it on
 * all of them. Nothing is moved, and fragments may overlap at the proposed poses. One thread an
 * instance, never the haptic one.
 */
public final class Reassembly {
  /** A proposal is uncertain if the score of another place is more than this part of its own. */
  private static final double MOST_NEXT = 0.5;

  /** A proposal is uncertain if its score is less than this part of the fragment's surface. */
  private static final double LEAST_OF_SURFACE = 0.01;

  private final GlobalFit fits;
  private final List<Pose> present;
  private final List<Pose> proposed = new ArrayList<>();
  private final boolean[] inPlace;
  private final int mostPairs;
  private int comparedPairs;
  private Progress progress = (done, total) -> {};

  /** The proposal for each pair of fragments, made when it is needed first; null before. */
  private final List<List<Optional<GlobalFit.Proposal>>> found = new ArrayList<>();

  /**
   * A fragment that is added to one in place.
   *
   * @param fragment the index of the fragment
   * @param other the index of the fragment that it fits to
   * @param scoreMm2 the area that speaks for the pose less the area against it, mm^2
   * @param nextScoreMm2 the best score of the fragment at another place, mm^2; 0 without one
   * @param surfaceMm2 the area of the whole surface of the fragment, mm^2
   */
  public record Joint(
      int fragment, int other, double scoreMm2, double nextScoreMm2, double surfaceMm2) {
    /**
     * {@return whether another place has more than half of the score, or the score is less than a
     * hundredth of the surface}
     */
    public boolean isUncertain() {
      return nextScoreMm2 > MOST_NEXT * scoreMm2 || scoreMm2 < LEAST_OF_SURFACE * surfaceMm2;
    }
  }

  /** Receives how far the comparison of pairs of fragments is. */
  public interface Progress {
    /**
     * Receives numbers of pairs.
     *
     * @param done the pairs that were compared
     * @param total the most pairs that are compared until all fragments are added
     */
    void compared(int done, int total);
  }

  /** A fragment at the pose that it was proposed beside one that is in place. */
  private record Offer(int fragment, int other, Pose pose, double scoreMm2, double nextScoreMm2) {}

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
    int fixed = inPlace.length - left().size();
    mostPairs = (inPlace.length * (inPlace.length - 1) - fixed * (fixed - 1)) / 2;
  }

  /**
   * Chooses who hears of the progress.
   *
   * @param receiver receives the progress after each pair that is compared
   */
  public void onProgress(Progress receiver) {
    progress = receiver;
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
    List<Offer> offers = new ArrayList<>();
    for (int n = 0; n < inPlace.length; n++) {
      for (int m = 0; m < inPlace.length && !inPlace[n]; m++) {
        if (inPlace[m] && fit(n, m).isPresent()) {
          offers.add(offer(n, m));
        }
      }
    }
    Optional<Offer> best =
        offers.stream()
            .filter(each -> each.scoreMm2 > 0)
            .max(Comparator.comparingDouble(each -> each.scoreMm2));
    best.ifPresent(each -> place(each.fragment, each.pose));
    return best.map(each -> joint(each, offers));
  }

  /** Returns what is proposed for a fragment beside another, in view of all that are in place. */
  private Offer offer(int fragment, int other) {
    GlobalFit.Proposal fit = fit(fragment, other).orElseThrow();
    Pose pose = present.get(other).inverseMultiply(fit.pose(), new Pose());
    proposed.get(other).multiply(pose, pose).rotation.normalize();
    double scoreMm2 = fit.scoreMm2();
    for (int n = 0; n < inPlace.length; n++) {
      if (inPlace[n] && n != other) {
        Pose relative = proposed.get(n).inverseMultiply(pose, new Pose());
        scoreMm2 += fits.score(fragment, n, relative);
      }
    }
    return new Offer(fragment, other, pose, scoreMm2, fit.nextScoreMm2());
  }

  /** Returns an offer with the best score of its fragment at another place. */
  private Joint joint(Offer best, List<Offer> offers) {
    double next = best.nextScoreMm2;
    for (Offer each : offers) {
      if (each.fragment == best.fragment && fits.isElsewhere(each.fragment, each.pose, best.pose)) {
        next = Math.max(next, each.scoreMm2);
      }
    }
    return new Joint(
        best.fragment, best.other, best.scoreMm2, next, fits.surfaceMm2(best.fragment));
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
      progress.compared(++comparedPairs, mostPairs);
    }
    return row.get(other);
  }

  /** Lays a fragment on all that are in place. */
  private void place(int fragment, Pose pose) {
    proposed.get(fragment).set(pose);
    List<Integer> others =
        IntStream.range(0, inPlace.length).filter(n -> inPlace[n]).boxed().toList();
    proposed.get(fragment).set(fits.settled(fragment, others, proposed));
    proposed.get(fragment).rotation.normalize();
    inPlace[fragment] = true;
  }
}
