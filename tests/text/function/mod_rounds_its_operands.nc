O1 (section 4.2: 17.6 MOD 5 is 18 MOD 5)
#100=17.6 MOD 5 (expect #100=3)
M30
