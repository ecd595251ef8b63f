power(50)
line(1,0)
' (finally records: power 50; line X1 Y0 Z0 F6000; power 0; end)
