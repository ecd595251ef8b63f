O1 (section 4.2)
#100=17 MOD 5 (expect #100=2)
#101=-17 MOD 5 (expect #101=-2)
#102=17 MOD -5 (expect #102=2)
M30
