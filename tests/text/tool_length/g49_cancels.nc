(run with: --set #11001=100)
O1 (TLC-1: Z5. is 5 again)
G90 G43 H1 Z10.
G49 Z5.
#100=#5023 (expect #100=5)
#101=#5083 (expect #101=0)
M30
