O1 (CALL-13: it moves nothing either)
G66 P2 X5. (expect moves: none)
#101=#100 (expect #101=null)
G67
M30
O2
#100=1
M99
