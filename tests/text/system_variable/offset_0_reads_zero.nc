O1 (section 3.5: #2000 means no offset)
#100=#2000 (expect #100=0)
M30
