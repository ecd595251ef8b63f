(run with: --set #11001=100)
O1 (TLC-5: it is back with the next Z move)
G90 G43 H1 Z10.
G53 Z5.
#100=#5023 (expect #100=5)
G00 Z20.
#101=#5023 (expect #101=120)
M30
