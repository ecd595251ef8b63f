(run with: --set #11001=100)
O1 (TLC-1: machine Z is 10 + 100, the tip is at 10)
G90 G43 H1 Z10. (expect moves: rapid Z10)
#100=#5003 (expect #100=10)
#101=#5043 (expect #101=110)
#102=#5023 (expect #102=110)
M30
(finally machine Z110)
