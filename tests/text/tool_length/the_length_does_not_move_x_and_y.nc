(run with: --set #11001=100)
O1 (TLC-1: only Z)
G90 G43 H1 X3. Y4. Z10. (expect moves: rapid X3 Y4 Z10)
#100=#5021 (expect #100=3)
#101=#5081 (expect #101=0)
M30
