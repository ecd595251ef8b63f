O1 (EXP-4: 2*3 MOD 4 is 6 MOD 4)
#100=2*3 MOD 4 (expect #100=2)
#101=7 MOD 4*2 (expect #101=6)
M30
