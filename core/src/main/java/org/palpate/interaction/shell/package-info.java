/**
 * A tool of many points worked on by a fixed pool of threads.
 *
 * <p>Uses {@code proxy}. The haptic thread calls, takes a share itself and returns when all is
 * done.
 */
package org.palpate.interaction.shell;
