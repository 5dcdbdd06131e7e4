package org.palpate.frame;

import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.rigid.ToolContacts;
import org.palpate.rigid.ToolMotion;

/**
 * The result of one frame, for those who assess or record a session.
 *
 * <p>Positions are millimetres, in the world for a rigid tool and along the axes of the grid for a
 * point. One thread at a time; nothing in it allocates.
 */
public final class FrameRecord {
  /** The most contacts of one frame. */
  public static final int MOST_CONTACTS = ToolContacts.MOST;

  /** The time of the device's sample, ns. */
  public long timeNanos;

  /** The position of the device. */
  public final Vec3 deviceMm = new Vec3();

  /** The pose of the tool, of the body in hand, or of the interaction point, which never turns. */
  public final Pose tool = new Pose();

  /** The force that was written to the device, N. */
  public final Vec3 forceNewton = new Vec3();

  /** The length of the force of contact alone, without guides and effects, N. */
  public double pressingNewton;

  /** Whether a solid holds the tool back. */
  public boolean contact;

  /** Whether the tool was set free, so that its motion in this frame is no path. */
  public boolean freed;

  /** Whether the device jumped, so that its motion in this frame is no path. */
  public boolean relocated;

  /** The index of the body in hand; -1 if the hand holds the tool. */
  public int heldBody = -1;

  private final int[] objects = new int[MOST_CONTACTS];
  private final double[] shares = new double[MOST_CONTACTS];
  private int contacts;

  /** {@return the number of contacts whose object is known} */
  public int contacts() {
    return contacts;
  }

  /**
   * {@return the index in the scene of the object that a contact touches}
   *
   * @param contactIndex the number of the contact, from 0 to {@link #contacts()} - 1
   */
  public int object(int contactIndex) {
    return objects[contactIndex];
  }

  /**
   * {@return the part of the pressing force that a contact carries; the parts add up to 1}
   *
   * @param contactIndex the number of the contact, from 0 to {@link #contacts()} - 1
   */
  public double share(int contactIndex) {
    return shares[contactIndex];
  }

  /** Forgets the contacts. */
  public void clearContacts() {
    contacts = 0;
  }

  /**
   * Adds a contact; there must be fewer than {@link #MOST_CONTACTS}.
   *
   * @param object the index in the scene of the object that the contact touches
   * @param share the part of the pressing force that it carries
   */
  public void addContact(int object, double share) {
    objects[contacts] = object;
    shares[contacts++] = share;
  }

  /** Takes contact and touched object of an interaction point. */
  void take(InteractionPoint point) {
    clearContacts();
    contact = point.contact;
    if (contact && point.touchedObject != InteractionPoint.NO_OBJECT) {
      addContact(point.touchedObject, 1);
    }
  }

  /** Takes the pose and the contacts of a rigid tool. */
  void take(ToolMotion motion) {
    clearContacts();
    tool.set(motion.pose());
    contact = motion.contact();
    ToolContacts touched = motion.contacts();
    for (int n = 0; contact && n < touched.count(); n++) {
      addContact(touched.body(n), touched.share(n));
    }
  }
}
