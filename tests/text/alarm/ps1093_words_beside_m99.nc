O1 (PS1093: a word beside M99 while G66 is on)
G66 P3
M98 P2
M30
O2
M08 M99 (expect alarm PS1093)
O3
M99
