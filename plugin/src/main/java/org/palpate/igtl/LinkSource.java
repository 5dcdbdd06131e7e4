package org.palpate.igtl;

/** Fills in the state of a session; called on the server's own thread, up to 60 times a second. */
@FunctionalInterface
public interface LinkSource {
  /** Writes the present state into {@code dest}. */
  void read(LinkState dest);
}
