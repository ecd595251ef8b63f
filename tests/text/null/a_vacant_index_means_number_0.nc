O1 (NUL-7: #[#1] is #0)
#100=1
#100=#[#1] (expect #100=null)
M30
