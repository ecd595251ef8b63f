speed(10); power(50)
burn(0.1); power(20); line(5,0)
' (finally records: power 50; dwell 0.1; power 0; power 20; line X5 Y0 Z0 F600; power 0; end)
