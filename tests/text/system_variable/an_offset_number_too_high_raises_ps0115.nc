O1 (section 3.5: there are 400 offsets)
#100=#10400 (expect #100=0)
#101=#10401 (expect alarm PS0115)
M30
