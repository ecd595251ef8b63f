O1 (M99-5: one call a block)
M98 P2 M98 P3 (expect alarm PS1091)
M30
O2
#100=1
M99
O3
M99
(finally #100=null)
