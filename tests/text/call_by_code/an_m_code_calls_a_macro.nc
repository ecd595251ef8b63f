(run with: --param 6080=80)
O1 (section 6.4: 6080 is O9020, with arguments)
M80 A1. X20.
M30
O9020
#100=#1 (expect #100=1)
#101=#24 (expect #101=20)
M99
(finally moves: none)
