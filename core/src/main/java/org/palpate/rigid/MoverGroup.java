package org.palpate.rigid;

import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;

/**
 * A mover and those that it carries along as if they were glued to it. The first member is the
 * mover itself. Poses of the others follow from its pose and are rounded like all poses. Haptic
 * thread only; allocates nothing after its creation.
 */
final class MoverGroup {
  private final MoverVerifier[] members;

  /** The pose of each member in the frame of the first one's sample points. */
  private final Pose[] inFrame;

  /** The pose that each member had when the first one stood at {@link #joinedAt}. */
  private final Pose[] joined;

  private final Pose joinedAt = new Pose();
  private final Pose carried = new Pose();
  private final Vec3 centre = new Vec3();
  private int size = 1;

  /**
   * Creates a group of one.
   *
   * @param most the largest number of members
   */
  MoverGroup(MoverVerifier first, int most) {
    members = new MoverVerifier[most];
    inFrame = new Pose[most];
    joined = new Pose[most];
    for (int m = 0; m < most; m++) {
      inFrame[m] = new Pose();
      joined[m] = new Pose();
    }
    members[0] = first;
  }

  /** Returns the number of members, at least 1. */
  int size() {
    return size;
  }

  /** Returns a member by its index; that of the mover that carries the others is 0. */
  MoverVerifier member(int index) {
    return members[index];
  }

  /** Whether a mover is a member. */
  boolean contains(Mover one) {
    return one.carrier == members[0].mover;
  }

  /** Adds a mover at its present pose. It must neither carry others nor be carried. */
  void add(MoverVerifier other) {
    assert other.mover.carrier == other.mover && !other.carriesOthers() : "moves with others";
    Pose first = members[0].pose();
    joinedAt.set(first);
    members[size] = other;
    other.mover.carrier = members[0].mover;
    ReferencePose.relative(first, other.pose(), inFrame[size++]);
    for (int m = 1; m < size; m++) {
      joined[m].set(members[m].pose()); // those that joined before may have moved since
    }
  }

  /** Lets all members but the first one stay where they are. */
  void dissolve() {
    while (size > 1) {
      Mover other = members[--size].mover;
      other.carrier = other;
    }
  }

  /** Returns the distance of the reference point of a member from that of the first one, mm. */
  double awayMm(int index) {
    members[0].pose().inverseTransform(members[index].pose().translation, centre);
    return index == 0 ? 0 : centre.length() * (1 + 1e-9);
  }

  /** Proposes a pose of the first member, and those of the others that follow from it. */
  void propose(Pose proposal) {
    members[0].mover.propose(proposal);
    boolean isWhereTheyJoined = proposal.sameBits(joinedAt);
    for (int m = 1; m < size; m++) {
      members[m].mover.propose(
          isWhereTheyJoined ? joined[m] : ReferencePose.glued(proposal, inFrame[m], carried));
    }
  }

  /** Commits the proposed poses. */
  void commit() {
    for (int m = 0; m < size; m++) {
      members[m].mover.commit();
    }
  }
}
