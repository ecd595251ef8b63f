O1 (M99-4: while G66 is on M99 stands alone)
G66 P3
M98 P2
M30
O2
X5. M99 (expect alarm PS1093)
O3
M99
