/**
 * Keeps the process alive when its X server goes away.
 *
 * <p>Uses JNA alone. The command line installs the handler before it opens a window; the handler
 * runs in the thread that met the broken connection.
 */
package org.palpate.display;
