O1 (section 4.2: 5.5 AND 3 is 6 AND 3)
#100=5.5 AND 3 (expect #100=2)
#101=12 OR 10 (expect #101=14)
M30
