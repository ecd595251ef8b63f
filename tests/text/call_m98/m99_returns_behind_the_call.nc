O1 (M99-1: to the block after the call)
#100=1
M98 P2
#101=#100+1 (expect #101=3)
M30
O2
#100=#100+1
M99
#100=99
