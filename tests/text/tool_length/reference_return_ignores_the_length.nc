(run with: --set #11001=100)
O1 (TLC-5: the spindle reaches machine 0)
G90 G43 H1 Z10.
G91 G28 Z0
#100=#5023 (expect #100=0)
G90 G00 Z20.
#101=#5023 (expect #101=120)
M30
