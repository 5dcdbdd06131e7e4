/** Palpate inside volume platforms: the packed plug-in in the real ImageJ, and hosts of our own. */
package org.palpate.platform;
