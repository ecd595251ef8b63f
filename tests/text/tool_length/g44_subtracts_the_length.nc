(run with: --set #11001=100)
O1 (TLC-1: machine Z is 10 - 100)
G90 G44 H1 Z10.
#100=#5003 (expect #100=10)
#101=#5023 (expect #101=-90)
M30
